// SPDX-License-Identifier: Apache-2.0
// Reads a .oni file with OpenNI in a process of its own. OpenNI's reader (seen with Debian's
// 2.2.0.33) trusts the file: a damaged one lets it write where it must not. Here that ends this
// process only. Threading: nothing else may use OpenNI in this process.
#pragma once

#include <string>

namespace roomcast::source {

/// Writes oni_messages.h to the pipe `out` at the file's pace, until the file ends (never, if
/// `loop`), it cannot be read, or nobody reads the pipe any more.
void read_oni_file(const std::string& file, bool loop, int out);

}  // namespace roomcast::source
