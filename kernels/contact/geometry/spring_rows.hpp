#pragma once
// The contacts that give way: contact.enforcement as rows and checks see it.

namespace percuss {

/// The rows that springs push: none (kinematic, lagrange); those of a sheet with anything but a wall, as its nodes
/// carry the whole thickness, which would stop with all that moves (automatic); or all (penalty).
enum class SpringRows : unsigned char { none, of_sheets, all };

}  // namespace percuss
