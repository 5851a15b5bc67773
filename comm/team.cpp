#include "comm/team.hpp"

#include <algorithm>

namespace percuss {

namespace {

constexpr int team_tag = 1;

bool contains_all(const std::vector<char>& team, const std::vector<char>& members) {
  for (std::size_t r = 0; r < team.size(); ++r)
    if (members[r] != 0 && team[r] == 0) return false;
  return true;
}

std::vector<char> join(std::vector<char> team, const std::vector<char>& members) {
  for (std::size_t r = 0; r < team.size(); ++r) team[r] = static_cast<char>(team[r] | members[r]);
  return team;
}

}  // namespace

void Team::meet(const std::vector<char>& has_work) {
  has_worked_ = join(std::move(has_worked_), has_work);
  ++meetings_;
  if (!contains_all(is_in_, has_work)) {
    form(join(is_in_, has_work));
  } else if (meetings_ >= patience) {
    if (has_worked_ != is_in_) form(has_worked_);
    has_worked_ = has_work;
    meetings_ = 0;
  }
}

void Team::leave() {
  if (handle_ != MPI_COMM_NULL) MPI_Comm_free(&handle_);
  handle_ = MPI_COMM_NULL;
}

/// Ranks that leave free their communicator as well, which is collective over it.
void Team::form(const std::vector<char>& members) {
  leave();
  is_in_ = members;
  size_ = static_cast<int>(std::count(is_in_.begin(), is_in_.end(), 1));
  ++formations_;
  if (size_ == ranks_.size() || !contains_this()) return;
  std::vector<int> list;
  for (int r = 0; r < ranks_.size(); ++r)
    if (contains(r)) list.push_back(r);
  MPI_Group all = MPI_GROUP_NULL, team = MPI_GROUP_NULL;
  check_mpi(MPI_Comm_group(ranks_.handle(), &all), "MPI_Comm_group");
  check_mpi(MPI_Group_incl(all, size_, list.data(), &team), "MPI_Group_incl");
  wait_mpi([&] { return MPI_Comm_create_group(ranks_.handle(), team, team_tag, &handle_); }, "MPI_Comm_create_group");
  check_mpi(MPI_Group_free(&team), "MPI_Group_free");
  check_mpi(MPI_Group_free(&all), "MPI_Group_free");
  check_mpi(MPI_Comm_set_errhandler(handle_, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
}

}  // namespace percuss
