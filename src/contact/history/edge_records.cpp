#include "src/contact/history/edge_records.hpp"

#include "kernels/core/host_copy.hpp"

namespace percuss {

HeldRecords take_held(const EdgeHistory& history) {
  const auto a = to_host(history.a), b = to_host(history.b);
  const auto holds = to_host(history.holds);
  const auto normal = to_host(history.normal), impulse = to_host(history.impulse), slip = to_host(history.slip);
  const auto reference = to_host(history.reference), energy = to_host(history.held), to_push = to_host(history.to_push);
  HeldRecords held;
  for (int r = 0; r < history.count; ++r) {
    if (holds(r) == 0) continue;
    held.a.push_back(a(r));
    held.b.push_back(b(r));
    for (const auto& rows : {normal, impulse, slip})
      for (int k = 0; k < 3; ++k) held.values.push_back(rows(r, k));
    held.values.insert(held.values.end(), {reference(r), energy(r), to_push(r)});
  }
  return held;
}

EdgeHistory make_edge_history(const HeldRecords& held) {
  std::vector<std::array<double, 3>> rows[3];
  std::vector<double> values[3];
  for (std::size_t r = 0; r < held.a.size(); ++r) {
    const double* const v = held.values.data() + HeldRecords::value_count * r;
    for (std::size_t i = 0; i < 3; ++i) rows[i].push_back({v[3 * i], v[3 * i + 1], v[3 * i + 2]});
    for (std::size_t i = 0; i < 3; ++i) values[i].push_back(v[9 + i]);
  }
  EdgeHistory history;
  history.count = static_cast<int>(held.a.size());
  history.a = to_view("contact::edge_history_a", held.a);
  history.b = to_view("contact::edge_history_b", held.b);
  history.holds = to_view("contact::edge_history_holds", std::vector<int>(held.a.size(), 1));
  history.normal = to_rows("contact::edge_history_normal", rows[0]);
  history.impulse = to_rows("contact::edge_history_impulse", rows[1]);
  history.slip = to_rows("contact::edge_history_slip", rows[2]);
  history.reference = to_view("contact::edge_history_reference", values[0]);
  history.held = to_view("contact::edge_history_held", values[1]);
  history.to_push = to_view("contact::edge_history_to_push", values[2]);
  return history;
}

}  // namespace percuss
