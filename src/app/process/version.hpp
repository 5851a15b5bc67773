#pragma once
// The version and the build of this program.

#include <string>

namespace percuss {

/// Text of `percuss --version`, in lines: version and back end; commit, where the sources were a checkout when it was
/// built, and whether they were changed; compiler and options; libraries.
std::string describe_version();

}  // namespace percuss
