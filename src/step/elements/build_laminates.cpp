#include "src/step/elements/build_laminates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/shell/layer_of_law.hpp"
#include "kernels/shell/shell_hourglass.hpp"
#include "src/deck/laws/laminates.hpp"
#include "src/deck/laws/law_traits.hpp"
#include "src/deck/laws/make_material.hpp"

namespace percuss {
namespace {

/// A ply and its place in the thickness from -1 to 1.
struct PlacedPly {
  PlyMaterial material;
  OrthotropicPly elastic;  // its elastic constants, whatever its law
  double g13 = 0, g23 = 0;
  double cosine = 1, sine = 0;
  double bottom = 0, top = 0;
};

/// In-plane stiffness in axes that a ply's are turned from: 11, 22, 12, 66.
struct PlaneStiffness {
  double q11 = 0, q22 = 0, q12 = 0, q66 = 0;
};

PlaneStiffness find_stiffness(const OrthotropicPly& ply) {
  const double over = 1 / (1 - ply.nu12 * ply.nu21);
  return {ply.e1 * over, ply.e2 * over, ply.nu21 * ply.e1 * over, ply.g12};
}

/// Stiffness Q11 in a direction at the ply's angle (Jones, section 2.6).
double turn_q11(const PlaneStiffness& q, double cosine, double sine) {
  const double cc = cosine * cosine, ss = sine * sine;
  return q.q11 * cc * cc + 2 * (q.q12 + 2 * q.q66) * cc * ss + q.q22 * ss * ss;
}

void set_law(const LaminatePly& from, PlacedPly& ply) {
  MaterialDeck material;
  material.law = from.law;
  visit_law(material, [&]<class Law>(const Law& law) {
    if constexpr (LayerLaw<Law>) ply.material = make_ply(law, from.density);
    if constexpr (std::is_same_v<Law, Orthotropic>) {
      ply.elastic = ply.material.orthotropic;
      ply.g13 = law.constants.shear_moduli[2];
      ply.g23 = law.constants.shear_moduli[1];
    } else if constexpr (LayerLaw<Law>) {
      ply.elastic = OrthotropicPly::make(find_layer_elasticity(law.moduli()));
      ply.g13 = ply.g23 = law.moduli().mu;
    }
  });
}

std::vector<PlacedPly> place_plies(const std::vector<LaminatePly>& list) {
  std::vector<PlacedPly> plies;
  double height = -1;
  for (const LaminatePly& from : list) {
    PlacedPly ply;
    set_law(from, ply);
    const double angle = from.angle * (std::numbers::pi / 180);
    ply.cosine = std::cos(angle);
    ply.sine = std::sin(angle);
    ply.bottom = height;
    ply.top = height += 2 * from.share;
    plies.push_back(ply);
  }
  return plies;
}

/// Stiffness in transverse shear along one direction over the thickness, from the energy of the shear stresses that
/// balance bending along it (Whitney 1973). stiffness(ply), shear(ply): in that direction.
template <class Stiffness, class Shear>
double find_shear_along(const std::vector<PlacedPly>& plies, const Stiffness& stiffness, const Shear& shear) {
  double sum = 0, first = 0;
  for (const PlacedPly& ply : plies) {
    sum += stiffness(ply) * (ply.top - ply.bottom);
    first += stiffness(ply) * 0.5 * (ply.top * ply.top - ply.bottom * ply.bottom);
  }
  const double neutral = first / sum;
  const ThicknessPoints gauss = find_thickness_points(3);  // exact: the square of the stress is of the fourth degree
  double bending = 0, energy = 0, below = 0;               // below: first moment of what lies below a ply
  for (const PlacedPly& ply : plies) {
    const double e = stiffness(ply), half = 0.5 * (ply.top - ply.bottom), middle = 0.5 * (ply.top + ply.bottom);
    const double low = ply.bottom - neutral, high = ply.top - neutral;
    for (int i = 0; i < gauss.count; ++i) {
      const double z = middle + half * gauss.place[i] - neutral;
      const double moment = below + 0.5 * e * (z * z - low * low);
      energy += gauss.weight[i] * 2 * half * moment * moment / shear(ply);
    }
    bending += e * (high * high * high - low * low * low) / 3;
    below += 0.5 * e * (high * high - low * low);
  }
  return bending * bending / (2 * energy);  // by the thickness, which is 2 here
}

ShearStiffness find_shear(const std::vector<PlacedPly>& plies) {
  const auto along_x = [](const PlacedPly& ply) { return turn_q11(find_stiffness(ply.elastic), ply.cosine, ply.sine); };
  const auto along_y = [](const PlacedPly& ply) {
    return turn_q11(find_stiffness(ply.elastic), -ply.sine, ply.cosine);
  };
  const auto g_x = [](const PlacedPly& ply) {
    return ply.g13 * ply.cosine * ply.cosine + ply.g23 * ply.sine * ply.sine;
  };
  const auto g_y = [](const PlacedPly& ply) {
    return ply.g13 * ply.sine * ply.sine + ply.g23 * ply.cosine * ply.cosine;
  };
  double x = 0, y = 0, xy = 0;
  for (const PlacedPly& ply : plies) {
    const double share = 0.5 * (ply.top - ply.bottom);
    x += share * g_x(ply);
    y += share * g_y(ply);
    xy += share * (ply.g13 - ply.g23) * ply.cosine * ply.sine;
  }
  ShearStiffness shear{find_shear_along(plies, along_x, g_x), find_shear_along(plies, along_y, g_y), 0};
  shear.xy = xy * std::sqrt(shear.xx * shear.yy / (x * y));  // corrected as the mean of both
  return shear;
}

/// Isotropic constants with the invariants of the plies' mean stiffness (Tsai and Pagano 1968).
PlaneElasticity find_mean_elasticity(const std::vector<PlacedPly>& plies) {
  double u1 = 0, u4 = 0;
  for (const PlacedPly& ply : plies) {
    const PlaneStiffness q = find_stiffness(ply.elastic);
    const double share = 0.5 * (ply.top - ply.bottom);
    u1 += share * (3 * q.q11 + 3 * q.q22 + 2 * q.q12 + 4 * q.q66) / 8;
    u4 += share * (q.q11 + q.q22 + 6 * q.q12 - 4 * q.q66) / 8;
  }
  return find_plane_elasticity((u1 * u1 - u4 * u4) / u1, u4 / u1);
}

/// E I of strains as tensors, with the largest eigenvalue of any ply, and of transverse shear.
PlaneElasticity find_bound_elasticity(const std::vector<PlacedPly>& plies, const ShearStiffness& shear) {
  double largest = 0;
  for (const PlacedPly& ply : plies) {
    const PlaneStiffness q = find_stiffness(ply.elastic);
    const double half = 0.5 * (q.q11 - q.q22);
    largest = std::max({largest, 0.5 * (q.q11 + q.q22) + std::hypot(half, q.q12), 2 * q.q66});
  }
  const double across = 0.5 * (shear.xx + shear.yy) + std::hypot(0.5 * (shear.xx - shear.yy), shear.xy);
  return find_plane_elasticity(std::max(largest, 2 * across / shell_shear_correction), 0);
}

ThicknessPoints find_rule(const std::vector<PlacedPly>& plies, int points) {
  const ThicknessPoints of_ply = find_thickness_points(points);
  ThicknessPoints rule;
  double sum = 0;
  for (const PlacedPly& ply : plies) {
    const double half = 0.5 * (ply.top - ply.bottom), middle = 0.5 * (ply.top + ply.bottom);
    for (int i = 0; i < points; ++i) {
      const int p = rule.count++;
      rule.place[p] = middle + half * of_ply.place[i];
      rule.weight[p] = half * of_ply.weight[i];
      rule.bending[p] = rule.weight[p] * rule.place[p] * rule.place[p];
      sum += rule.bending[p];
    }
  }
  for (int p = 0; p < rule.count; ++p) rule.bending[p] = sum > 0 ? rule.bending[p] / sum : rule.weight[p];
  return rule;
}

/// Place of the law of ply i among those of the laminate, by the names of the plies' materials.
std::vector<int> number_materials(const std::vector<LaminatePly>& plies, std::vector<std::size_t>& first) {
  std::vector<int> numbers;
  for (const LaminatePly& ply : plies) {
    const auto same =
        std::find_if(first.begin(), first.end(), [&](std::size_t i) { return plies[i].material == ply.material; });
    numbers.push_back(static_cast<int>(same - first.begin()));
    if (same == first.end()) first.push_back(numbers.size() - 1);
  }
  return numbers;
}

bool starts_at_zero(const PlyMaterial& ply) {
  if (ply.kind != PlyMaterial::Kind::hardening) return true;
  std::vector<double> history(static_cast<std::size_t>(ply.hardening.count_history()));
  ply.hardening.start(history.data());
  return std::all_of(history.begin(), history.end(), [](double value) { return value == 0; });
}

}  // namespace

Laminate make_laminate(const MaterialDeck& material, int points) {
  const std::vector<LaminatePly> list = list_plies(material);
  const std::vector<PlacedPly> plies = place_plies(list);
  const bool is_metal = plies.front().material.kind == PlyMaterial::Kind::anisotropic_metal;
  const int each = count_points_of_ply(plies.size(), points, is_metal && material.plies.empty());
  Laminate laminate;
  laminate.rule = find_rule(plies, each);
  std::vector<std::size_t> first;
  const std::vector<int> numbers = number_materials(list, first);
  for (std::size_t m = 0; m < first.size(); ++m) laminate.layer.materials[m] = plies[first[m]].material;
  for (int p = 0; p < laminate.rule.count; ++p) {
    const auto i = static_cast<std::size_t>(p / each);
    laminate.layer.points[p] = {numbers[i], plies[i].cosine, plies[i].sine};
    laminate.can_yield = laminate.can_yield || plies[i].material.kind != PlyMaterial::Kind::orthotropic;
    laminate.can_fail = laminate.can_fail || plies[i].material.orthotropic.can_fail;
  }
  laminate.layer.elasticity = find_mean_elasticity(plies);
  laminate.layer.shear = find_shear(plies);
  laminate.layer.bound = is_metal && first.size() == 1 ? plies.front().material.anisotropic_metal.elasticity
                                                       : find_bound_elasticity(plies, laminate.layer.shear);
  return laminate;
}

std::string find_laminate_fault(const MaterialDeck& material) {
  const std::vector<LaminatePly> list = list_plies(material);
  for (const LaminatePly& ply : list) {
    MaterialDeck own;
    own.law = ply.law;
    bool known = false;
    visit_law(own, [&]<class Law>(const Law& law) {
      if constexpr (LayerLaw<Law>) known = starts_at_zero(make_ply(law, ply.density));
    });
    if (!known) return fmt::format("material '{}', of the model {}, cannot be a ply", ply.material, ply.law.model);
  }
  std::vector<std::size_t> first;
  number_materials(list, first);
  if (first.size() > LaminateLayer::most_materials)
    return fmt::format("its plies have {} materials, and at most {} can be", first.size(),
                       LaminateLayer::most_materials);
  return {};
}

std::optional<Vector3<double>> find_given_axis(const MaterialDeck& material) {
  const std::vector<LaminatePly> list = list_plies(material);
  const auto has_axes = [](const LawDeck& law) { return find_traits(law.model).has_axes; };
  const auto first = std::find_if(list.begin(), list.end(), [&](const LaminatePly& ply) { return has_axes(ply.law); });
  if (first == list.end()) return std::nullopt;  // no direction matters
  MaterialDeck of;
  of.law = has_axes(material.law) ? material.law : first->law;
  std::optional<Vector3<double>> axis;
  visit_law(of, [&]<class Law>(const Law& law) {
    if constexpr (requires { law.constants.follows_elements; }) {
      if (!law.constants.follows_elements) axis = make_direction(law.constants.first_axis);
    }
  });
  return axis;
}

PlaneDirection<double> find_reference_axis(const std::optional<Vector3<double>>& given,
                                           const Vector3<double> (&corners)[4], const Matrix3<double>& frame) {
  const Vector3<double> axis = given.value_or(corners[1] - corners[0]), local = frame * axis;
  const double length = std::hypot(local.x, local.y);
  constexpr double least = 1e-3;  // share of the axis; below it its direction in the plane is round-off
  if (!(length > least * norm(axis))) return {0, 0};
  return {local.x / length, local.y / length};
}

}  // namespace percuss
