// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GdcmMessages.h
 * @brief What GDCM writes to the terminal while it reads a file.
 */
#ifndef BoneDecimate_Applications_GdcmMessages_h
#define BoneDecimate_Applications_GdcmMessages_h

#include <gdcmTrace.h>

#include <iostream>
#include <sstream>
#include <string>

namespace bonedecimate::volume
{
/// As long as it lives, the messages of GDCM go nowhere, because they may quote the header.
class GdcmMessages
{
public:
  GdcmMessages()
  {
    gdcm::Trace::SetWarningStream(this->Text);
    gdcm::Trace::SetErrorStream(this->Text);
  }

  ~GdcmMessages()
  {
    gdcm::Trace::SetWarningStream(std::cerr);
    gdcm::Trace::SetErrorStream(std::cerr);
  }

  GdcmMessages(const GdcmMessages&) = delete;
  GdcmMessages& operator=(const GdcmMessages&) = delete;

  /// GDCM fills up what is missing of the pixels and reads on; "use file at own risk" is all it
  /// says.
  bool TellOfMissingPixels() const
  {
    return this->Text.str().find("at own risk") != std::string::npos;
  }

private:
  std::ostringstream Text;
};
}

#endif
