#include "meshing/cameras/thin_border.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace lumi {
namespace {

constexpr int kNone = -1;

bool is_thin_over(const std::vector<Eigen::Vector3d>& directions, double thin_altitude, int from,
                  int to, int tip) {
    const Eigen::Vector3d edge =
        directions[static_cast<std::size_t>(to)] - directions[static_cast<std::size_t>(from)];
    const Eigen::Vector3d side =
        directions[static_cast<std::size_t>(tip)] - directions[static_cast<std::size_t>(from)];
    return edge.cross(side).norm() < thin_altitude * edge.squaredNorm();
}

/// Triangles that can be taken off at the border, each in constant time.
class Peel {
 public:
    Peel(const std::vector<Eigen::Vector3d>& directions, double thin_altitude,
         const std::vector<std::array<int, 3>>& faces)
        : directions_(directions),
          thin_altitude_(thin_altitude),
          faces_(faces),
          across_(faces.size(), {kNone, kNone, kNone}),
          is_off_(faces.size(), 0),
          on_border_(directions.size(), 0) {
        join_neighbours();
    }

    /// In rounds from the border inwards: a triangle is looked at when it has come to the border.
    void run() {
        std::vector<int> reached;
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            if (mark_border(face)) reached.push_back(static_cast<int>(face));
        }
        while (!reached.empty()) reached = round(reached);
    }

    [[nodiscard]] const std::vector<char>& is_off() const { return is_off_; }

 private:
    void join_neighbours() {
        struct Side {
            int lesser, greater, face, edge;
        };
        std::vector<Side> sides;
        sides.reserve(3 * faces_.size());
        for (std::size_t face = 0; face < faces_.size(); ++face) {
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [lesser, greater] =
                    std::minmax({faces_[face][i], faces_[face][(i + 1) % 3]});
                sides.push_back({lesser, greater, static_cast<int>(face), static_cast<int>(i)});
            }
        }
        std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
            return a.lesser != b.lesser ? a.lesser < b.lesser : a.greater < b.greater;
        });
        for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
            const Side& a = sides[i];
            const Side& b = sides[i + 1];
            if (a.lesser != b.lesser || a.greater != b.greater) continue;
            neighbour(a.face, a.edge) = b.face;
            neighbour(b.face, b.edge) = a.face;
        }
    }
    int& neighbour(int face, int edge) {
        return across_[static_cast<std::size_t>(face)][static_cast<std::size_t>(edge)];
    }

    /// Whether the face has an edge on the border, whose ends are noted.
    bool mark_border(std::size_t face) {
        bool has_border = false;
        for (std::size_t i = 0; i < 3; ++i) {
            if (across_[face][i] != kNone) continue;
            has_border = true;
            on_border_[static_cast<std::size_t>(faces_[face][i])] = 1;
            on_border_[static_cast<std::size_t>(faces_[face][(i + 1) % 3])] = 1;
        }
        return has_border;
    }

    [[nodiscard]] bool comes_off(std::size_t face) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int tip = faces_[face][(i + 2) % 3];
            char& tip_on_border = on_border_[static_cast<std::size_t>(tip)];
            if (across_[face][i] != kNone || tip_on_border) continue;
            if (!is_thin_over(directions_, thin_altitude_, faces_[face][i],
                              faces_[face][(i + 1) % 3], tip)) {
                continue;
            }
            // The next thin triangle at this tip must not pinch the border.
            tip_on_border = 1;
            return true;
        }
        return false;
    }

    /// The faces that come to the border by what is taken off now, in ascending order.
    std::vector<int> round(const std::vector<int>& reached) {
        std::vector<int> taken;
        for (const int face : reached) {
            if (!is_off_[static_cast<std::size_t>(face)] &&
                comes_off(static_cast<std::size_t>(face))) {
                taken.push_back(face);
            }
        }
        std::vector<int> next;
        for (const int face : taken) {
            is_off_[static_cast<std::size_t>(face)] = 1;
            for (const int other : across_[static_cast<std::size_t>(face)]) {
                if (other == kNone) continue;
                for (int& back : across_[static_cast<std::size_t>(other)]) {
                    if (back == face) back = kNone;
                }
                next.push_back(other);
            }
        }
        std::sort(next.begin(), next.end());
        next.erase(std::unique(next.begin(), next.end()), next.end());
        return next;
    }

    const std::vector<Eigen::Vector3d>& directions_;
    double thin_altitude_;
    const std::vector<std::array<int, 3>>& faces_;
    std::vector<std::array<int, 3>> across_;  ///< The face beyond each edge.
    std::vector<char> is_off_;
    std::vector<char> on_border_;
};

}  // namespace

void peel_thin_border(const std::vector<Eigen::Vector3d>& directions, double thin_altitude,
                      std::vector<std::array<int, 3>>& faces) {
    Peel peel(directions, thin_altitude, faces);
    peel.run();
    std::vector<std::array<int, 3>> left;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        if (!peel.is_off()[face]) left.push_back(faces[face]);
    }
    faces = std::move(left);
}

}  // namespace lumi
