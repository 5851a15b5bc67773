#include "src/contact/ranks/motion_copy.hpp"

#include "kernels/core/host_copy.hpp"
#include "kernels/core/small_space.hpp"
#include "kernels/core/view_copy.hpp"
#include "src/contact/surface/number_map.hpp"

namespace percuss {
namespace {

MotionPart to_views(const ItemPart& part) {
  return {part,
          part.request,
          to_view("contact::motion_rows", part.asked),
          to_view("contact::published_nodes", part.published),
          to_view("contact::own_rows", part.own),
          to_view("contact::own_nodes", part.own_places)};
}

}  // namespace

void MotionCopy::name(const ContactRanks& ranks, UnstructuredExchange& exchange, DataExchange& data,
                      const std::vector<std::int64_t>& numbers) {
  NumberWalk walk(ranks.mesh.node_numbers);
  nodes_.name(exchange, data, NodeOwners(ranks.numbering).find(numbers), numbers,
              [&](std::int64_t number) { return walk.find(number); });
  reserve(x_, static_cast<int>(numbers.size()));
  reserve(v_, static_cast<int>(numbers.size()));
}

MotionPart MotionCopy::all() const { return to_views(nodes_.all()); }
MotionPart MotionCopy::select(DataExchange& data, const std::vector<char>& is_wanted) const {
  return to_views(nodes_.select(data, is_wanted));
}
MotionPart MotionCopy::select_among(const MotionPart& part, DataExchange& data, const std::vector<char>& is_wanted) {
  return to_views(RemoteItems::select_among(part.items, data, is_wanted));
}

void MotionCopy::begin(DataExchange& data, const MotionPart& part, const SurfaceMotion& motion) {
  const int sent = static_cast<int>(part.published.extent(0)), received = static_cast<int>(part.rows.extent(0));
  reserve(sent_, sent);
  reserve(received_, received);
  const Array<const int> published = part.published;
  const Array<NodeMotion> send = sent_;
  const SurfaceMotion m = motion;
  loop_where_it_pays(
      "contact::pack_motion", sent, sent / 10, KOKKOS_LAMBDA(int i) {
        for (int k = 0; k < 3; ++k) {
          send(i).x[k] = m.x(published(i), k);
          send(i).v[k] = m.v(published(i), k);
        }
      });
  send_buffer_ = to_host(sent_);
  receive_buffer_ = Kokkos::create_mirror_view(received_);
  data.begin<NodeMotion>(reverse(part.request), {send_buffer_.data(), send_buffer_.extent(0)},
                         {receive_buffer_.data(), receive_buffer_.extent(0)});
}

SurfaceMotion MotionCopy::end(DataExchange& data, const MotionPart& part, const SurfaceMotion& motion) {
  const Rows3<double> x = x_, v = v_;
  const SurfaceMotion m = motion;
  const Array<const int> own_rows = part.own_rows, own_nodes = part.own_nodes, rows = part.rows;
  const Array<NodeMotion> received = received_;
  const int own = static_cast<int>(own_rows.extent(0)), others = static_cast<int>(rows.extent(0));
  // While the messages are under way.
  loop_where_it_pays(
      "contact::copy_own_motion", own, own / 10, KOKKOS_LAMBDA(int i) {
        for (int k = 0; k < 3; ++k) {
          x(own_rows(i), k) = m.x(own_nodes(i), k);
          v(own_rows(i), k) = m.v(own_nodes(i), k);
        }
      });
  data.end();
  copy_values(received_, receive_buffer_);
  loop_where_it_pays(
      "contact::unpack_motion", others, others / 10, KOKKOS_LAMBDA(int i) {
        for (int k = 0; k < 3; ++k) {
          x(rows(i), k) = received(i).x[k];
          v(rows(i), k) = received(i).v[k];
        }
      });
  return {x_, v_, motion.dt};
}

}  // namespace percuss
