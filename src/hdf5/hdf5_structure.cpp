#include "src/hdf5/hdf5_structure.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <array>
#include <fstream>
#include <set>
#include <string_view>
#include <vector>

#include "src/error.hpp"
#include "src/hdf5/hdf5_handle.hpp"

namespace percuss::hdf5 {
namespace {

#if H5_VERSION_GE(1, 12, 0)
using ObjectInfo = H5O_info1_t;
#else
using ObjectInfo = H5O_info_t;
#endif

/// Least bytes that a link takes in a file: a name and where it leads.
constexpr std::size_t least_link_bytes = 8;

struct Link {
  std::string name;
  H5L_type_t type;
};

struct LinkList {
  std::vector<Link> links;
  std::size_t most;  // links that the file has room for
};

herr_t collect_link(hid_t, const char* name, const H5L_info_t* info, void* data) {
  auto& list = *static_cast<LinkList*>(data);
  if (list.links.size() >= list.most) return -1;
  list.links.push_back({name, info->type});
  return 0;
}

std::string read_storage_file(hid_t properties, unsigned index) {
  std::array<char, 1024> name{};
  off_t offset = 0;
  hsize_t bytes = 0;
  check(H5Pget_external(properties, index, name.size() - 1, name.data(), &offset, &bytes), "read external storage");
  return name.data();
}

std::string read_source_file(hid_t properties, std::size_t index) {
  std::array<char, 1024> name{};
  check(H5Pget_virtual_filename(properties, index, name.data(), name.size()), "read a virtual dataset");
  return name.data();
}

class Walk {
 public:
  Walk(std::size_t most_links, ExternalFiles external) : most_links_(most_links), external_(external) {}

  void visit_group(hid_t group, const std::string& path, int depth) {
    if (depth > deepest_group)
      throw InputError(
          fmt::format("its groups are nested more than {} deep (at '{}'): write the file again", deepest_group, path));
    LinkList list{{}, most_links_};
    check(H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect_link, &list), "list group " + path);
    for (const Link& link : list.links) visit_link(group, link, path + "/" + link.name, depth);
  }

  /// Visits soft links after all groups: only now is it known that no link on the way leads to another file.
  void visit_soft_links(hid_t root) {
    for (const std::string& path : soft_links_) {  // one that leads nowhere is an error of whoever opens it
      if (H5Oexists_by_name(root, path.c_str(), H5P_DEFAULT) > 0) visit_object(root, path, path, 0);
    }
  }

  void note_group(hid_t group, const std::string& path) {
    if (!groups_.insert(find_address(group)).second) {
      throw InputError(
          fmt::format("group '{}' can be reached in more than one way (following its links could loop for ever): write "
                      "the file again",
                      path));
    }
  }

 private:
  static haddr_t find_address(hid_t object) {
    ObjectInfo info;
    check(H5Oget_info2(object, &info, H5O_INFO_BASIC), "look at an object");
    return info.addr;
  }

  void visit_link(hid_t group, const Link& link, const std::string& path, int depth) {
    if (link.type == H5L_TYPE_HARD)
      visit_object(group, link.name, path, depth);
    else if (link.type == H5L_TYPE_SOFT)
      soft_links_.push_back(path);
    else
      refuse_external(fmt::format("link '{}' leads to another file", path));
  }

  void visit_object(hid_t parent, const std::string& name, const std::string& path, int depth) {
    const Handle object(check(H5Oopen(parent, name.c_str(), H5P_DEFAULT), "open " + path), H5Oclose);
    const H5I_type_t type = H5Iget_type(object.get());
    if (type == H5I_GROUP) {
      note_group(object.get(), path);
      visit_group(object.get(), path, depth + 1);
    } else if (type == H5I_DATASET) {
      visit_dataset(object.get(), path);
    }
  }

  void visit_dataset(hid_t dataset, const std::string& path) const {
    const Handle properties(check(H5Dget_create_plist(dataset), "look at dataset " + path), H5Pclose);
    const int storages = check(H5Pget_external_count(properties.get()), "look at dataset " + path);
    for (int i = 0; i < storages; ++i)
      refuse_external(fmt::format("dataset '{}' has its values in another file, '{}'", path,
                                  read_storage_file(properties.get(), static_cast<unsigned>(i))));
    if (H5Pget_layout(properties.get()) != H5D_VIRTUAL) return;
    std::size_t sources = 0;
    check(H5Pget_virtual_count(properties.get(), &sources), "look at dataset " + path);
    for (std::size_t i = 0; i < sources; ++i) {
      const std::string file = read_source_file(properties.get(), i);
      if (file != ".")
        refuse_external(fmt::format("virtual dataset '{}' has its values in another file, '{}'", path, file));
    }
  }

  void refuse_external(const std::string& problem) const {
    if (external_ == ExternalFiles::allow) return;
    throw InputError(problem +
                     " (with such links an untrusted file could read your other files): copy the data into one file, "
                     "or give --allow-external if you trust it");
  }

  std::set<haddr_t> groups_;
  std::vector<std::string> soft_links_;
  std::size_t most_links_;
  ExternalFiles external_;
};

std::size_t find_bytes(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

}  // namespace

void check_structure(const std::string& path, ExternalFiles external) {
  const QuietErrors quiet;
  try {
    const Handle access(check(H5Pcreate(H5P_FILE_ACCESS), "open it"), H5Pclose);
    check(H5Pset_file_locking(access.get(), false, true), "open it");
    const Handle file(check(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), "open it as HDF5"), H5Fclose);
    const Handle root(check(H5Gopen2(file.get(), "/", H5P_DEFAULT), "open its root"), H5Gclose);
    Walk walk(find_bytes(path) / least_link_bytes, external);
    walk.note_group(root.get(), "/");
    walk.visit_group(root.get(), "", 0);
    walk.visit_soft_links(root.get());
  } catch (const Error& error) {
    throw InputError(
        fmt::format("the file is damaged (HDF5 cannot {}: {}): write or copy it again", error.what(), error.reason));
  }
}

// As HDF5 looks for it: at the start, or behind a user block of 512 bytes or that times a power of two.
bool has_hdf5_signature(const std::string& path) {
  std::array<char, 8> bytes{};
  std::ifstream stream(path, std::ios::binary);
  const std::size_t end = find_bytes(path);
  for (std::size_t at = 0; at + bytes.size() <= end; at = at == 0 ? 512 : 2 * at) {
    stream.seekg(static_cast<std::streamoff>(at));
    stream.read(bytes.data(), bytes.size());
    if (!stream.good()) return false;
    if (std::string_view(bytes.data(), bytes.size()) == "\x89HDF\r\n\x1a\n") return true;
  }
  return false;
}

}  // namespace percuss::hdf5
