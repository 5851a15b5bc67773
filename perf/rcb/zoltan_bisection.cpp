#include <zoltan.h>

#include <stdexcept>

#include "perf/rcb/bisection.hpp"

namespace percuss::perf {
namespace {

using Points = std::vector<HeldPoint>;

const Points& get_points(void* data) { return **static_cast<const Points**>(data); }

int count_points(void* data, int* error) {
  *error = ZOLTAN_OK;
  return static_cast<int>(get_points(data).size());
}

void list_points(void* data, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int, float*, int* error) {
  const Points& points = get_points(data);
  for (std::size_t i = 0; i < points.size(); ++i) {
    global[i] = static_cast<ZOLTAN_ID_TYPE>(points[i].id);
    local[i] = static_cast<ZOLTAN_ID_TYPE>(i);
  }
  *error = ZOLTAN_OK;
}

int count_dimensions(void*, int* error) {
  *error = ZOLTAN_OK;
  return 3;
}

void list_places(void* data, int, int, int count, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local, int, double* places, int* error) {
  const Points& points = get_points(data);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) places[3 * i + k] = points[local[i]].x[k];
  }
  *error = ZOLTAN_OK;
}

void check_zoltan(int code, const char* call) {
  if (code != ZOLTAN_OK) throw std::runtime_error(std::string(call) + " failed");
}

Zoltan_Struct* as_zoltan(void* zoltan) { return static_cast<Zoltan_Struct*>(zoltan); }

}  // namespace

ZoltanBisection::ZoltanBisection(const Communicator& ranks) : rank_(ranks.rank()) {
  float version = 0;
  check_zoltan(Zoltan_Initialize(0, nullptr, &version), "Zoltan_Initialize");
  zoltan_ = Zoltan_Create(ranks.handle());
  if (zoltan_ == nullptr) throw std::runtime_error("Zoltan_Create failed");
  const char* const parameters[][2] = {{"DEBUG_LEVEL", "0"},     {"LB_METHOD", "RCB"},    {"NUM_GID_ENTRIES", "1"},
                                       {"NUM_LID_ENTRIES", "1"}, {"OBJ_WEIGHT_DIM", "0"}, {"RETURN_LISTS", "EXPORT"},
                                       {"KEEP_CUTS", "1"},       {"RCB_REUSE", "1"},      {"RCB_OUTPUT_LEVEL", "0"},
                                       {"CHECK_GEOM", "0"}};
  for (const auto& [name, value] : parameters)
    check_zoltan(Zoltan_Set_Param(as_zoltan(zoltan_), name, value), "Zoltan_Set_Param");
}

ZoltanBisection::~ZoltanBisection() {
  Zoltan_Struct* zoltan = as_zoltan(zoltan_);
  Zoltan_Destroy(&zoltan);
}

std::vector<int> ZoltanBisection::find_owners(const Points& points) {
  Zoltan_Struct* const zoltan = as_zoltan(zoltan_);
  const Points* data = &points;
  Zoltan_Set_Num_Obj_Fn(zoltan, count_points, &data);
  Zoltan_Set_Obj_List_Fn(zoltan, list_points, &data);
  Zoltan_Set_Num_Geom_Fn(zoltan, count_dimensions, &data);
  Zoltan_Set_Geom_Multi_Fn(zoltan, list_places, &data);
  int changes = 0, gids = 0, lids = 0, import_count = 0, export_count = 0;
  ZOLTAN_ID_PTR import_global = nullptr, import_local = nullptr, export_global = nullptr, export_local = nullptr;
  int *import_ranks = nullptr, *import_parts = nullptr, *export_ranks = nullptr, *export_parts = nullptr;
  check_zoltan(
      Zoltan_LB_Partition(zoltan, &changes, &gids, &lids, &import_count, &import_global, &import_local, &import_ranks,
                          &import_parts, &export_count, &export_global, &export_local, &export_ranks, &export_parts),
      "Zoltan_LB_Partition");
  std::vector<int> owners(points.size(), rank_);
  for (int i = 0; i < export_count; ++i) owners[export_local[i]] = export_ranks[i];
  Zoltan_LB_Free_Part(&import_global, &import_local, &import_ranks, &import_parts);
  Zoltan_LB_Free_Part(&export_global, &export_local, &export_ranks, &export_parts);
  return owners;
}

}  // namespace percuss::perf
