#pragma once
// What this rank still does before it ends all ranks at once.

#include <functional>

namespace percuss {

/// Communicator::abort() calls `action` first, in place of the one given before; an empty one is none. It must neither
/// wait for other ranks nor throw.
void do_before_abort(std::function<void()> action);

}  // namespace percuss
