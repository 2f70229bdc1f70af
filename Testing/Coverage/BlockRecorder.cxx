// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockRecorder.cxx
 * @brief Records which basic blocks each test case runs, for Utilities/select_sanitized_tests.py.
 *
 * The core is compiled with -fsanitize-coverage=trace-pc: each block calls
 * __sanitizer_cov_trace_pc. Each test case appends one record to the file that BONEDECIMATE_BLOCKS
 * names, on three lines: its name, its seconds and the offsets of its blocks in the program.
 */
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <memory>

extern "C" char __executable_start; // NOLINT(bugprone-reserved-identifier): the linker's name
extern "C" char etext;

namespace
{
std::size_t TextSize()
{
  return static_cast<std::size_t>(&etext - &__executable_start);
}

std::atomic<std::atomic<std::uint8_t>*> Reached{ nullptr };

class BlockRecorder : public testing::EmptyTestEventListener
{
public:
  explicit BlockRecorder(const char* file)
    : Records(file)
    , Flags(new std::atomic<std::uint8_t>[TextSize()]())
  {
    Reached = this->Flags.get();
  }

  ~BlockRecorder() override { Reached = nullptr; }

  void OnTestStart(const testing::TestInfo& /*info*/) override
  {
    for (std::size_t i = 0; i < TextSize(); ++i)
    {
      this->Flags[i].store(0, std::memory_order_relaxed);
    }
  }

  void OnTestEnd(const testing::TestInfo& info) override
  {
    this->Records << info.test_suite_name() << '.' << info.name() << '\n'
                  << info.result()->elapsed_time() / 1000.0 << '\n';
    for (std::size_t i = 0; i < TextSize(); ++i)
    {
      if (this->Flags[i].load(std::memory_order_relaxed) != 0)
      {
        this->Records << i << ' ';
      }
    }
    this->Records << std::endl;
  }

private:
  std::ofstream Records;
  std::unique_ptr<std::atomic<std::uint8_t>[]> Flags;
};
}

extern "C" void
__sanitizer_cov_trace_pc() // NOLINT(bugprone-reserved-identifier): the compiler's name
{
  std::atomic<std::uint8_t>* const flags = Reached.load(std::memory_order_relaxed);
  if (flags != nullptr)
  {
    const auto block = static_cast<std::size_t>(
      static_cast<const char*>(__builtin_return_address(0)) - &__executable_start);
    if (block < TextSize()) // a tail call returns to a library
    {
      flags[block].store(1, std::memory_order_relaxed);
    }
  }
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  const char* const file = std::getenv("BONEDECIMATE_BLOCKS");
  if (file != nullptr)
  {
    testing::UnitTest::GetInstance()->listeners().Append(new BlockRecorder(file));
  }
  return RUN_ALL_TESTS();
}
