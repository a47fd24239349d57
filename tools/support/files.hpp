// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace enfilade {

/// All of `text` or nothing: through a temporary file beside `path`, unless that is no file that could be
/// replaced, but /dev/stdout or a pipe. Throws std::runtime_error naming what cannot be written.
void write_file(const std::string& path, const std::string& text);

/// Makes `folder`, with those above it, where it is not there. Throws std::runtime_error naming it.
void make_folder(const std::string& folder);

/// What the name of a file ends in, in small letters, with its dot: ".pcd".
std::string ending_of(const std::string& path);

/// Why no file `path` can be written, or no folder `path` made and written into, as far as that shows without
/// trying; empty if nothing speaks against it. For whoever works long before the first write.
std::string why_no_file(const std::string& path);
std::string why_no_folder(const std::string& path);

}  // namespace enfilade
