#pragma once
// Which contacts give way: contact.enforcement as rows and checks see it.

namespace percuss {

/// Which rows springs push: none (kinematic, lagrange); those of nodes that carry the whole thickness of a sheet, on
/// both sides, which would stop with all that moves (automatic); or all (penalty).
enum class SpringRows : unsigned char { none, of_sheets, all };

}  // namespace percuss
