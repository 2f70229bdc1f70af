// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfJson.h"

#include <string>

namespace bonedecimate
{
namespace
{
using Json = nlohmann::json;

/// Adds up what values take and stops at the limit.
class MemoryCounter : public nlohmann::json_sax<Json>
{
public:
  explicit MemoryCounter(std::size_t most)
    : Most(most)
  {
  }

  bool IsBeyond() const { return this->Bytes > this->Most; }

  bool null() override { return this->Add(OfValue); }
  bool boolean(bool) override { return this->Add(OfValue); }
  bool number_integer(number_integer_t) override { return this->Add(OfValue); }
  bool number_unsigned(number_unsigned_t) override { return this->Add(OfValue); }
  bool number_float(number_float_t, const string_t&) override { return this->Add(OfValue); }
  bool string(string_t& text) override { return this->Add(OfString + text.size()); }
  bool binary(binary_t&) override { return this->Add(OfString); }
  bool start_object(std::size_t) override { return this->Add(OfObject); }
  bool key(string_t& text) override { return this->Add(OfKey + text.size()); }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return this->Add(OfObject); }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override
  {
    return false;
  }

private:
  // With the growth of lists and what the heap adds.
  static constexpr std::size_t OfValue = 48;
  static constexpr std::size_t OfString = 112;
  static constexpr std::size_t OfKey = 96;
  static constexpr std::size_t OfObject = 144;

  bool Add(std::size_t bytes)
  {
    this->Bytes += bytes;
    return !this->IsBeyond();
  }

  std::size_t Most;
  std::size_t Bytes = 0;
};
}

bool FitsJson(std::string_view text, std::size_t mostBytes)
{
  MemoryCounter counter(mostBytes);
  Json::sax_parse(text, &counter);
  return !counter.IsBeyond();
}
}
