#include "meshing/cameras/arrangement.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "calib/work/error.h"
#include "calib/work/median.h"
#include "meshing/cameras/border.h"
#include "meshing/cameras/forward_motion.h"
#include "meshing/cameras/spherical_triangulation.h"

namespace lumi {
namespace {

/// A band of directions is a line when it is this much thinner than it is long,
constexpr double kLineThickness = 0.08;
/// or when its heights scatter by less than half the spacing along it: then which of two neighbours
/// is higher is chance. A band of n evenly spaced directions has the spacing sqrt(12) / (n - 1) of
/// its standard deviation.
constexpr double kLineHeightOverSpacing = 0.5;
constexpr double kMostLineThickness = 0.5;
/// The same where most triangles between its cameras would be thin.
constexpr double kThinLineThickness = 0.25;
/// A triangle is thin when its least altitude is below this share of the median edge.
constexpr double kThinAltitude = 0.3;
/// A ring above or below the scene is a line up to this sine of its elevation; higher up the
/// view from the pole is as natural as from the ring, and the hull serves it better.
constexpr double kMaxRingElevation = 0.7;
constexpr std::size_t kLeastRing = 5;
/// A strip about a ring that is asked for keeps this share of its cameras' distance free for the
/// scene; of fewer cameras or higher up less is left, and a line that they lie along serves better.
constexpr double kLeastRoomInRing = 0.34;
/// A ring has no camera nearer to its axis than this share of the farthest one's distance from it.
constexpr double kRingHole = 0.5;
/// A cap without cameras is a gap when its radius is larger than this, and than three usual ones.
constexpr double kLeastGap_deg = 60.0;
/// Caps near a half-sphere are gaps in any case: the plane of their face passes the centre.
constexpr double kSureGap_deg = 85.0;

/// Square roots of the eigenvalues of the directions' second moments, and the eigenvector of the
/// least one. `about` is subtracted first.
struct Spread {
    Eigen::Vector3d sigmas = Eigen::Vector3d::Zero();  ///< Descending.
    Eigen::Vector3d least_axis = Eigen::Vector3d::UnitY();
};

Spread spread_about(const std::vector<Eigen::Vector3d>& directions, const Eigen::Vector3d& about) {
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& direction : directions) {
        moments += (direction - about) * (direction - about).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
    const Eigen::Vector3d ascending = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return {ascending.reverse(), solver.eigenvectors().col(0)};
}

Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3d>& directions) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& direction : directions) mean += direction;
    return mean / static_cast<double>(directions.size());
}

double thickness(const Spread& spread) {
    return spread.sigmas[1] > 0 ? spread.sigmas[2] / spread.sigmas[1] : 0.0;
}

double line_thickness_limit(std::size_t cameras) {
    const double half_spacing =
        kLineHeightOverSpacing * std::sqrt(12.0) / static_cast<double>(cameras - 1);
    return std::clamp(half_spacing, kLineThickness, kMostLineThickness);
}

/// Normal of the plane that the cameras' places lie nearest to.
Eigen::Vector3d plane_of_places(const CameraStar& star) {
    std::vector<Eigen::Vector3d> places;
    for (std::size_t i = 0; i < star.directions.size(); ++i) {
        places.push_back(star.distances[i] * star.directions[i]);
    }
    return spread_about(places, mean_of(places)).least_axis;
}

std::string with_figure(const char* format, double figure) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), format, figure);
    return text.data();
}

/// The cone about the centre that directions lie near.
struct Cone {
    Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
    double thickness = 0.0;
    double sine_of_elevation = 0.0;
};

Cone cone_of(const std::vector<Eigen::Vector3d>& directions) {
    const Eigen::Vector3d mean = mean_of(directions);
    const Spread spread = spread_about(directions, mean);
    return {spread.least_axis, thickness(spread), std::abs(spread.least_axis.dot(mean))};
}

/// A row, arc or ring: directions near one plane through the centre, or near one cone about it.
std::optional<Arrangement> as_line(const CameraStar& star, double max_thickness) {
    Arrangement line;
    line.construction = MeshConstruction::kLine;
    const Spread plane = spread_about(star.directions, Eigen::Vector3d::Zero());
    if (thickness(plane) < max_thickness) {
        line.strip_normal = plane.least_axis;
        line.reason = with_figure(
            "the cameras stand in one row as seen from the scene (its height is %.1f %% of its "
            "length)",
            100 * thickness(plane));
        return line;
    }
    const Cone cone = cone_of(star.directions);
    if (star.directions.size() >= kLeastRing && cone.thickness < max_thickness &&
        cone.sine_of_elevation < kMaxRingElevation) {
        line.strip_normal = plane_of_places(star);
        line.reason =
            with_figure("the cameras stand on one ring or arc, %.0f degrees off the scene's level",
                        std::asin(cone.sine_of_elevation) * 180 / std::numbers::pi);
        return line;
    }
    return std::nullopt;
}

/// Whether the cameras stand around a cone's axis, with room for the scene. A patch or grid of
/// cameras on one side of the scene is flat along the line of sight, too, but not hollow.
bool stand_around(const std::vector<Eigen::Vector3d>& directions, const Cone& cone) {
    std::vector<double> sines;  // Of the angles to the axis.
    for (const Eigen::Vector3d& direction : directions) {
        sines.push_back(direction.cross(cone.axis).norm());
    }
    const auto [nearest, farthest] = std::minmax_element(sines.begin(), sines.end());
    const double room =
        *nearest * std::cos(std::numbers::pi / static_cast<double>(directions.size()));
    return *nearest > kRingHole * *farthest && room > kLeastRoomInRing;
}

/// Angular radius of the circumscribed cap of each face, the largest one's centre first.
struct Caps {
    std::vector<double> radii_deg;
    std::size_t largest = 0;
    Eigen::Vector3d largest_centre = Eigen::Vector3d::UnitZ();
};

Caps circumscribed_caps(const std::vector<Eigen::Vector3d>& directions,
                        const std::vector<std::array<int, 3>>& faces) {
    Caps caps;
    for (const auto& face : faces) {
        const Eigen::Vector3d& a = directions[static_cast<std::size_t>(face[0])];
        const Eigen::Vector3d& b = directions[static_cast<std::size_t>(face[1])];
        const Eigen::Vector3d& c = directions[static_cast<std::size_t>(face[2])];
        const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
        const double cosine = std::clamp(normal.dot(a), -1.0, 1.0);
        caps.radii_deg.push_back(std::acos(cosine) * 180 / std::numbers::pi);
        if (caps.radii_deg.back() > caps.radii_deg[caps.largest] || caps.radii_deg.size() == 1) {
            caps.largest = caps.radii_deg.size() - 1;
            caps.largest_centre = normal;
        }
    }
    return caps;
}

/// Share of triangles whose least altitude is small against the median edge.
double thin_share(const std::vector<Eigen::Vector3d>& directions,
                  const std::vector<std::array<int, 3>>& faces) {
    std::vector<double> edges;
    std::vector<double> altitudes;
    for (const auto& face : faces) {
        const Eigen::Vector3d& a = directions[static_cast<std::size_t>(face[0])];
        const Eigen::Vector3d& b = directions[static_cast<std::size_t>(face[1])];
        const Eigen::Vector3d& c = directions[static_cast<std::size_t>(face[2])];
        const std::array<double, 3> lengths{(b - a).norm(), (c - b).norm(), (a - c).norm()};
        edges.insert(edges.end(), lengths.begin(), lengths.end());
        altitudes.push_back((b - a).cross(c - a).norm() /
                            *std::max_element(lengths.begin(), lengths.end()));
    }
    if (faces.empty()) return 0.0;
    const double limit = kThinAltitude * median_of(edges);
    const auto thin = std::count_if(altitudes.begin(), altitudes.end(),
                                    [limit](double altitude) { return altitude < limit; });
    return static_cast<double>(thin) / static_cast<double>(faces.size());
}

/// Closed when every cap is small, else open towards the largest one. A patch seen from one side
/// is open opposite to the mean direction: the centre is then within the hull of the cameras and
/// that direction, so that every face looks away from the centre.
Arrangement as_surface(const CameraStar& star) {
    Arrangement surface;
    const auto faces = spherical_triangulation(star.directions);
    const Caps caps = circumscribed_caps(star.directions, faces);
    const double largest_deg = faces.empty() ? 180.0 : caps.radii_deg[caps.largest];
    const double limit_deg =
        faces.empty() ? 0.0
                      : std::clamp(3 * median_of(caps.radii_deg), kLeastGap_deg, kSureGap_deg);
    const bool one_sided = largest_deg >= 89.0;
    surface.gap_direction =
        one_sided ? Eigen::Vector3d(-mean_of(star.directions).normalized()) : caps.largest_centre;
    if (largest_deg <= limit_deg) {
        surface.construction = MeshConstruction::kClosed;
        surface.reason = with_figure(
            "the cameras surround the scene: the widest cap without one has a radius of %.0f "
            "degrees",
            largest_deg);
        return surface;
    }
    surface.construction = MeshConstruction::kOpen;
    surface.reason =
        one_sided
            ? std::string("the cameras see the scene from one side")
            : with_figure("there is no camera within %.0f degrees of one direction", largest_deg);
    return surface;
}

/// What a line that is asked for is stretched along: what `arrange` would take, if need be of a
/// thicker line; or the axis of a ring of any elevation that goes around the scene; else the axis
/// that directions lie least along.
Eigen::Vector3d demanded_strip_normal(const CameraStar& star) {
    for (const double max_thickness :
         {line_thickness_limit(star.directions.size()), kThinLineThickness}) {
        if (auto line = as_line(star, max_thickness)) return line->strip_normal;
    }
    const Cone cone = cone_of(star.directions);
    if (star.directions.size() > 2 && cone.thickness < kMostLineThickness &&
        stand_around(star.directions, cone)) {
        return plane_of_places(star);
    }
    return spread_about(star.directions, Eigen::Vector3d::Zero()).least_axis;
}

bool looks_away(const CameraStar& star) {
    std::size_t outward = 0;
    for (std::size_t i = 0; i < star.axes.size(); ++i) {
        if (star.axes[i].direction_in_world.dot(star.directions[i]) > 0) ++outward;
    }
    return 2 * outward > star.axes.size();
}

Arrangement arrange_by_shape(const CameraStar& star) {
    if (star.directions.size() == 1) {
        return {.construction = MeshConstruction::kSingle,
                .reason = star.hidden_cameras == 0
                              ? "there is one camera"
                              : "all cameras stand in one direction from the scene"};
    }
    if (star.directions.size() == 2) {
        return {.construction = MeshConstruction::kPair,
                .strip_normal = spread_about(star.directions, Eigen::Vector3d::Zero()).least_axis,
                .reason = "two cameras see the scene from different directions"};
    }
    if (auto line = as_line(star, line_thickness_limit(star.directions.size()))) return *line;
    const Arrangement surface = as_surface(star);
    if (surface.construction == MeshConstruction::kOpen) {
        const auto near_side = open_triangulation(star.directions, surface.gap_direction);
        if (thin_share(star.directions, near_side) > 0.5) {
            if (auto line = as_line(star, kThinLineThickness)) return *line;
        }
    }
    return surface;
}

}  // namespace

Arrangement arrange(const CameraStar& star) {
    Arrangement arrangement = arrange_by_shape(star);
    arrangement.inside_out = looks_away(star);
    return arrangement;
}

std::optional<Arrangement> arrange_forward(const std::vector<OpticalAxis>& axes) {
    const std::optional<ForwardMotion> motion = forward_motion(axes);
    if (!motion) return std::nullopt;
    return Arrangement{
        .construction = MeshConstruction::kNearest,
        .reason = with_figure("the cameras stand behind each other, %.0f degrees off their line of "
                              "sight",
                              motion->angle_deg)};
}

Arrangement arrange_as(const CameraStar& star, MeshConstruction construction) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::kDegenerateCapture, "E-MESH-CONSTRUCTION",
                    "a camera mesh of the construction '" + name_of(construction) +
                        "' was asked for, but " + why,
                    "leave [mesh] construction at \"auto\"");
    };
    Arrangement arrangement = as_surface(star);
    if (construction == MeshConstruction::kLine) {
        if (star.directions.size() < 2) refuse("all cameras stand in one direction");
        arrangement.strip_normal = demanded_strip_normal(star);
    } else if (construction == MeshConstruction::kOpen) {
        if (open_triangulation(star.directions, arrangement.gap_direction).empty()) {
            refuse("the cameras stand in one row");
        }
    } else if (construction == MeshConstruction::kClosed &&
               spherical_triangulation(star.directions).empty()) {
        refuse("the cameras' directions from the scene lie in one plane");
    }
    arrangement.construction = construction;
    arrangement.inside_out = construction != MeshConstruction::kNearest && looks_away(star);
    arrangement.reason = "it was asked for";
    return arrangement;
}

}  // namespace lumi
