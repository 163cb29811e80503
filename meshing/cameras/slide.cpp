#include "meshing/cameras/slide.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace lumi {
namespace {

constexpr double kTolerance = 1e-7;
constexpr int kMaxRounds = 20;
/// Row updates that one round may take; small programmes are solved to the last digit.
constexpr std::size_t kRoundWork = 200'000;
constexpr std::size_t kLeastSweeps = 40;
constexpr std::size_t kMostSweeps = 5000;
/// Slides shorter than this share of the distance are rounding.
constexpr double kNotable = 1e-6;
/// Shares of a virtual vertex's distance that it may end at.
constexpr double kNearestVirtual = 0.25;
constexpr double kFarthestVirtual = 4.0;

/// What moves as one: a vertex of a surface, or the pair of vertices of one camera in a strip.
struct Stand {
    std::vector<std::size_t> vertices;
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< From the centre, of length one.
    double distance = 0.0;
    bool is_virtual = false;
};

/// A plane through two or three stands: m . x = 1 with m = `from_inverse_distances`^T q.
struct Facet {
    std::array<int, 3> stands{};
    int count = 3;
    Eigen::Matrix3d from_inverse_distances;
};

struct StarShape {
    std::vector<Stand> stands;
    std::vector<Facet> facets;
};

/// Facets that the centre does not lie within are left out: no slide along the stands' directions
/// can turn them.
void append_facet(StarShape& shape, const std::array<int, 3>& stands, int count,
                  const Eigen::Matrix3d& directions) {
    if (!(directions.determinant() > 1e-12)) return;
    shape.facets.push_back({stands, count, directions.inverse()});
}

StarShape shape_of_surface(const CameraMesh& mesh) {
    StarShape shape;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Eigen::Vector3d offset =
            mesh.vertices[i].position_in_world - mesh.scene_centre_in_world;
        shape.stands.push_back(
            {{i}, offset.normalized(), offset.norm(), mesh.vertices[i].is_virtual});
    }
    for (const CameraMesh::Face& face : mesh.faces) {
        Eigen::Matrix3d directions;
        for (Eigen::Index corner = 0; corner < 3; ++corner) {
            directions.col(corner) =
                shape.stands[static_cast<std::size_t>(face[static_cast<std::size_t>(corner)])]
                    .direction;
        }
        append_facet(shape, face, 3, directions);
    }
    return shape;
}

/// A strip has its vertices in pairs, and two faces between neighbouring pairs.
StarShape shape_of_strip(const CameraMesh& mesh) {
    StarShape shape;
    const auto position = [&](std::size_t i) { return mesh.vertices[i].position_in_world; };
    const Eigen::Vector3d normal = (position(0) - position(1)).normalized();
    for (std::size_t i = 0; i + 1 < mesh.vertices.size(); i += 2) {
        const Eigen::Vector3d offset = position(i) - mesh.scene_centre_in_world;
        const Eigen::Vector3d across = offset - offset.dot(normal) * normal;
        shape.stands.push_back(
            {{i, i + 1}, across.normalized(), across.norm(), mesh.vertices[i].is_virtual});
    }
    std::set<std::array<int, 2>> seen;
    for (const CameraMesh::Face& face : mesh.faces) {
        std::set<int> pairs;
        for (const int corner : face) pairs.insert(corner / 2);
        std::array<int, 2> ends{*pairs.begin(), *pairs.rbegin()};
        if (!seen.insert(ends).second) continue;
        const auto direction = [&](int pair) {
            return shape.stands[static_cast<std::size_t>(pair)].direction;
        };
        Eigen::Matrix3d directions;
        directions << direction(ends[0]), direction(ends[1]), normal;
        if (directions.determinant() < 0) std::swap(ends[0], ends[1]);
        directions << direction(ends[0]), direction(ends[1]), normal;
        append_facet(shape, {ends[0], ends[1], 0}, 2, directions);
    }
    return shape;
}

/// coefficients . q[stands] <= bound, and its multiplier.
struct Row {
    std::array<int, 3> stands{};
    int count = 0;
    Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();
    double bound = 0.0;
    double curvature = 0.0;
    double multiplier = 0.0;
};

/// The quadratic programme in inverse distances; the unit of length is chosen by its caller.
class Programme {
 public:
    Programme(const StarShape& shape, std::vector<Eigen::Vector3d> scene,
              const SlideOptions& options)
        : shape_(shape), scene_(std::move(scene)), limit_(1.0 / (1.0 + options.room)) {
        for (const Stand& stand : shape.stands) {
            const double weight = stand.is_virtual ? options.virtual_weight : 1.0;
            q_.push_back(1.0 / stand.distance);
            compliance_.push_back(0.5 / (weight * std::pow(stand.distance, 4)));
            const double least = stand.is_virtual ? kNearestVirtual : 1 - options.longest_slide;
            const double most = stand.is_virtual ? kFarthestVirtual : 1 + options.longest_slide;
            least_q_.push_back(1.0 / (most * stand.distance));
            most_q_.push_back(1.0 / (least * stand.distance));
        }
        corners_in_rows_.resize(shape.facets.size());
        bounded_.resize(shape.stands.size(), 0);
    }

    /// Whether a solution was found.
    [[nodiscard]] bool solve() {
        for (int round = 0; round < kMaxRounds; ++round) {
            if (!add_violated_rows()) return true;
            ascend();
        }
        return false;
    }

    [[nodiscard]] const std::vector<double>& inverse_distances() const { return q_; }

 private:
    [[nodiscard]] double q_at(int stand) const { return q_[static_cast<std::size_t>(stand)]; }

    /// Adds the worst corner of each face whose plane cuts the scene. False when nothing is
    /// violated.
    bool add_violated_rows() {
        bool violated = false;
        for (std::size_t f = 0; f < shape_.facets.size(); ++f) {
            const Facet& facet = shape_.facets[f];
            Eigen::Vector3d q = Eigen::Vector3d::Zero();
            for (int i = 0; i < facet.count; ++i) {
                q[i] = q_at(facet.stands[static_cast<std::size_t>(i)]);
            }
            const Eigen::Vector3d plane = facet.from_inverse_distances.transpose() * q;
            std::size_t worst = 0;
            double farthest = -1;
            for (std::size_t s = 0; s < scene_.size(); ++s) {
                const double reach = plane.dot(scene_[s]);
                if (reach <= farthest) continue;
                farthest = reach;
                worst = s;
            }
            if (farthest <= limit_ + kTolerance) continue;
            violated = true;
            if (corners_in_rows_[f].insert(worst).second) add_face_row(facet, scene_[worst]);
        }
        return violated || out_of_bounds();
    }

    /// Constraints that contradict one another leave some bound violated.
    [[nodiscard]] bool out_of_bounds() const {
        for (std::size_t i = 0; i < q_.size(); ++i) {
            if (q_[i] > most_q_[i] + kTolerance || q_[i] < least_q_[i] - kTolerance) return true;
        }
        return false;
    }

    void add_face_row(const Facet& facet, const Eigen::Vector3d& corner) {
        Row row;
        row.stands = facet.stands;
        row.count = facet.count;
        row.coefficients = facet.from_inverse_distances * corner;
        row.bound = limit_;
        add(row);
        for (int i = 0; i < facet.count; ++i) {
            const int stand = facet.stands[static_cast<std::size_t>(i)];
            const auto index = static_cast<std::size_t>(stand);
            if (bounded_[index]) continue;
            bounded_[index] = 1;
            add({{stand, 0, 0}, 1, Eigen::Vector3d::UnitX(), most_q_[index], 0, 0});
            add({{stand, 0, 0}, 1, -Eigen::Vector3d::UnitX(), -least_q_[index], 0, 0});
        }
    }

    void add(Row row) {
        for (int i = 0; i < row.count; ++i) {
            row.curvature +=
                row.coefficients[i] * row.coefficients[i] *
                compliance_[static_cast<std::size_t>(row.stands[static_cast<std::size_t>(i)])];
        }
        if (row.curvature > 0) rows_.push_back(row);
    }

    /// Each row in turn is made to hold with the least change, or let go as far as it was needed.
    void ascend() {
        const std::size_t sweeps =
            std::clamp(kRoundWork / (rows_.size() + 1), kLeastSweeps, kMostSweeps);
        for (std::size_t sweep = 0; sweep < sweeps; ++sweep) {
            double largest_change = 0;
            for (Row& row : rows_) {
                double excess = -row.bound;
                for (int i = 0; i < row.count; ++i) {
                    excess += row.coefficients[i] * q_at(row.stands[static_cast<std::size_t>(i)]);
                }
                const double multiplier = std::max(0.0, row.multiplier + excess / row.curvature);
                const double change = multiplier - row.multiplier;
                if (change == 0) continue;
                row.multiplier = multiplier;
                largest_change = std::max(largest_change, std::abs(change) * row.curvature);
                for (int i = 0; i < row.count; ++i) {
                    const auto stand =
                        static_cast<std::size_t>(row.stands[static_cast<std::size_t>(i)]);
                    q_[stand] -= change * row.coefficients[i] * compliance_[stand];
                }
            }
            if (largest_change < 0.1 * kTolerance) return;
        }
    }

    const StarShape& shape_;
    std::vector<Eigen::Vector3d> scene_;
    double limit_;
    std::vector<double> q_;
    std::vector<double> compliance_;  ///< Change of q for each unit of force.
    std::vector<double> least_q_;
    std::vector<double> most_q_;
    std::vector<Row> rows_;
    std::vector<std::set<std::size_t>> corners_in_rows_;
    std::vector<char> bounded_;
};

double usual_distance(const StarShape& shape) {
    double sum = 0;
    int count = 0;
    for (const Stand& stand : shape.stands) {
        if (stand.is_virtual) continue;
        sum += stand.distance;
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

SlideReport move_vertices(CameraMesh& mesh, const StarShape& shape,
                          const std::vector<double>& inverse_distances, double unit) {
    SlideReport report;
    report.reached = true;
    double squares = 0;
    int cameras = 0;
    for (std::size_t i = 0; i < shape.stands.size(); ++i) {
        const Stand& stand = shape.stands[i];
        const double slide = unit / inverse_distances[i] - unit * stand.distance;
        const double share = std::abs(slide) / (unit * stand.distance);
        if (!stand.is_virtual) {
            ++cameras;
            squares += share * share;
            report.largest_share = std::max(report.largest_share, share);
            if (share > kNotable) ++report.cameras_slid;
        }
        if (share <= kNotable) continue;
        for (const std::size_t vertex : stand.vertices) {
            mesh.vertices[vertex].position_in_world += slide * stand.direction;
        }
    }
    report.rms_share = cameras > 0 ? std::sqrt(squares / cameras) : 0.0;
    return report;
}

}  // namespace

SlideReport slide_into_kernel(CameraMesh& mesh,
                              const std::vector<Eigen::Vector3d>& scene_hull_in_world,
                              const SlideOptions& options) {
    if (mesh.faces.empty() || scene_hull_in_world.empty()) return {};
    StarShape shape = is_strip(mesh) ? shape_of_strip(mesh) : shape_of_surface(mesh);
    const double unit = usual_distance(shape);
    if (!(unit > 0)) return {};
    for (Stand& stand : shape.stands) {
        stand.distance /= unit;
        if (!(stand.distance > 0)) return {};
    }
    std::vector<Eigen::Vector3d> scene;
    for (const Eigen::Vector3d& corner : scene_hull_in_world) {
        scene.emplace_back((corner - mesh.scene_centre_in_world) / unit);
    }
    Programme programme(shape, std::move(scene), options);
    if (!programme.solve()) return {};
    return move_vertices(mesh, shape, programme.inverse_distances(), unit);
}

}  // namespace lumi
