#include "src/output/hdf5/growing_dataset.hpp"

namespace percuss::hdf5 {
namespace {

// From the HDF5 file format specification, "Version 1 B-trees", with addresses and lengths of 8 bytes: a node has a
// header, keys of a chunk's size, filters and offsets (one more than the dimensions), and the addresses of its entries.
constexpr hsize_t node_header = 24, entry_bytes = 8 + (4 + 4 + 8 * 3);

// Where rows come at the end, a node that is full is split so that a tenth of its entries move (H5P_set_btree_ratios).
// A split adds a node; that of the root two; and the level above may split as well.
constexpr hsize_t most_nodes_of_split = 3;

hsize_t find_index_entries(hid_t dataset, const std::string& action) {
  const Handle file(check(H5Iget_file_id(dataset), action), H5Fclose);
  const Handle creation(check(H5Fget_create_plist(file.get()), action), H5Pclose);
  unsigned k = 0;
  check(H5Pget_istore_k(creation.get(), &k), action);
  return 2 * hsize_t{k};
}

hsize_t find_number_bytes(hid_t dataset, const std::string& action) {
  const Handle type(check(H5Dget_type(dataset), action), H5Tclose);
  return H5Tget_size(type.get());
}

}  // namespace

Handle create_dataset_properties(const std::string& action) {
  Handle properties(check(H5Pcreate(H5P_DATASET_CREATE), action), H5Pclose);
  check(H5Pset_obj_track_times(properties.get(), false), action);
  return properties;
}

Handle create_early_properties(const std::string& action) {
  Handle properties = create_dataset_properties(action);
  check(H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER), action);
  // One of several ranks, or one rank alone, may have begun the file.
  check(H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY), action);
  return properties;
}

GrowingDataset::GrowingDataset(hid_t parent, const std::string& name, hid_t file_type, const Layout& layout)
    : name_(name), layout_(layout) {
  const std::string action = "create dataset " + name;
  const int rank = layout.is_list ? 1 : 2;
  const std::array<hsize_t, 2> none{0, layout.row_length}, unlimited{H5S_UNLIMITED, layout.row_length},
      chunk{layout.chunk_rows, layout.chunk_length};
  const Handle space(check(H5Screate_simple(rank, none.data(), unlimited.data()), action), H5Sclose);
  const Handle properties = create_early_properties(action);
  check(H5Pset_chunk(properties.get(), rank, chunk.data()), action);
  dataset_ = {
      check(H5Dcreate2(parent, name.c_str(), file_type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
            action),
      H5Dclose};
  chunk_bytes_ = layout.chunk_rows * layout.chunk_length * H5Tget_size(file_type);
  index_entries_ = find_index_entries(id(), action);
}

GrowingDataset::GrowingDataset(hid_t parent, const std::string& name)
    : dataset_(check(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), "open dataset " + name), H5Dclose), name_(name) {
  const std::string action = "read the shape of " + name;
  const Handle space(check(H5Dget_space(id()), action), H5Sclose);
  const Handle properties(check(H5Dget_create_plist(id()), action), H5Pclose);
  std::array<hsize_t, 2> dims{0, 1}, chunk{1, 1};
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank != 1 && rank != 2) throw Error(action, "it has neither one nor two dimensions");
  if (H5Pget_layout(properties.get()) != H5D_CHUNKED) throw Error(action, "it cannot grow");
  check(H5Sget_simple_extent_dims(space.get(), dims.data(), nullptr), action);
  check(H5Pget_chunk(properties.get(), rank, chunk.data()), action);
  layout_ = {dims[1], rank == 1, chunk[0], chunk[1]};
  rows_ = dims[0];
  chunk_bytes_ = chunk[0] * chunk[1] * find_number_bytes(id(), action);
  index_entries_ = find_index_entries(id(), action);
}

void GrowingDataset::set_rows(hsize_t rows, const std::string& action) {
  const std::array<hsize_t, 2> extent{rows, layout_.row_length};
  check(H5Dset_extent(id(), extent.data()), action);
  rows_ = rows;
}

void GrowingDataset::extend(hsize_t rows) { set_rows(rows_ + rows, "extend dataset " + name_); }

void GrowingDataset::cut(hsize_t rows) {
  const std::string action = "cut dataset " + name_;
  if (rows > rows_) throw Error(action, "it has too few rows");
  if (rows < rows_) set_rows(rows, action);
}

hsize_t GrowingDataset::count_chunks(hsize_t rows) const {
  const auto divide_up = [](hsize_t n, hsize_t by) { return (n + by - 1) / by; };
  return divide_up(rows, layout_.chunk_rows) * divide_up(layout_.row_length, layout_.chunk_length);
}

hsize_t GrowingDataset::growth_bytes(hsize_t rows) const {
  const hsize_t before = count_chunks(rows_), after = count_chunks(rows_ + rows);
  if (after == before) return 0;
  const hsize_t node_bytes = node_header + index_entries_ * entry_bytes + entry_bytes;
  hsize_t nodes = before == 0 ? 1 : 0;
  if (after > index_entries_) nodes += most_nodes_of_split * (1 + 2 * (after - before) / index_entries_);
  return (after - before) * chunk_bytes_ + nodes * node_bytes;
}

}  // namespace percuss::hdf5
