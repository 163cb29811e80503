#include "calib/boards/lattice.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace lumi {
namespace {

constexpr std::array<LatticeCell, 4> kUnitSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

LatticeCell moved(const LatticeCell& cell, const LatticeCell& step, int times = 1) {
    return {cell.column + times * step.column, cell.row + times * step.row};
}

/// Two neighbours that may span the pattern, and how many of the six others around are there.
struct Seed {
    std::size_t at = 0;
    std::size_t next_column = 0;
    std::size_t next_row = 0;
};

bool has_point_at(const PointGrid& points, const Eigen::Vector2d& where_px, double radius_px) {
    return !points.within(where_px, radius_px).empty();
}

bool holds_together(const PointGrid& points, const Seed& seed, double tolerance) {
    const auto& px = points.points_px();
    const Eigen::Vector2d along_columns = px[seed.next_column] - px[seed.at];
    const Eigen::Vector2d along_rows = px[seed.next_row] - px[seed.at];
    const double radius_px = tolerance * std::min(along_columns.norm(), along_rows.norm());
    constexpr std::array<std::array<int, 2>, 6> kAround{
        {{1, 1}, {-1, 0}, {0, -1}, {1, -1}, {-1, 1}, {-1, -1}}};
    int found = 0;
    for (const auto& [columns, rows] : kAround) {
        const Eigen::Vector2d where_px = px[seed.at] + columns * along_columns + rows * along_rows;
        if (has_point_at(points, where_px, radius_px)) ++found;
    }
    constexpr int kEnough = 3;
    return found >= kEnough;
}

std::optional<Seed> seed_at(const PointGrid& points, const LinkTest& may_link, std::size_t at,
                            double tolerance) {
    constexpr std::size_t kNeighbours = 12;
    const auto& px = points.points_px();
    const std::vector<std::size_t> around = points.neighbours(at, kNeighbours);
    for (std::size_t a = 0; a < around.size(); ++a) {
        if (!may_link(at, around[a], 1, 0)) continue;
        const Eigen::Vector2d to_a = px[around[a]] - px[at];
        for (std::size_t b = a + 1; b < around.size(); ++b) {
            const Eigen::Vector2d to_b = px[around[b]] - px[at];
            const double cross = to_a.x() * to_b.y() - to_a.y() * to_b.x();
            constexpr double kSinLeastAngle = 0.35;  // 20 degrees.
            constexpr double kMaxRatio = 4.0;
            if (std::abs(cross) < kSinLeastAngle * to_a.norm() * to_b.norm()) continue;
            if (to_b.norm() > kMaxRatio * to_a.norm()) break;
            if (!may_link(at, around[b], 0, 1)) continue;
            const Seed seed =
                cross > 0 ? Seed{at, around[a], around[b]} : Seed{at, around[b], around[a]};
            if (holds_together(points, seed, tolerance)) return seed;
        }
    }
    return std::nullopt;
}

/// A lattice while it grows.
class Growth {
 public:
    Growth(const PointGrid& points, const LinkTest& may_link, const LatticeOptions& options)
        : points_(points),
          may_link_(may_link),
          options_(options),
          is_used_(points.points_px().size(), false) {}

    Lattice from(const Seed& seed) {
        add({0, 0}, seed.at);
        add({1, 0}, seed.next_column);
        add({0, 1}, seed.next_row);
        while (grow_by_one_ring()) {
        }
        return lattice_;
    }

 private:
    void add(const LatticeCell& cell, std::size_t point) {
        lattice_[cell] = point;
        is_used_[point] = true;
    }

    /// Cells `gap` steps from a node along a row or column that are not filled.
    std::set<LatticeCell> frontier(int gap) const {
        std::set<LatticeCell> cells;
        for (const auto& [cell, point] : lattice_) {
            for (const LatticeCell& step : kUnitSteps) {
                const LatticeCell next = moved(cell, step, gap);
                if (!lattice_.contains(next)) cells.insert(next);
            }
        }
        return cells;
    }

    bool links_to_neighbours(const LatticeCell& cell, std::size_t point, int gap) const {
        int linked = 0;
        for (const LatticeCell& step : kUnitSteps) {
            const auto neighbour = lattice_.find(moved(cell, step, -gap));
            if (neighbour == lattice_.end()) continue;
            if (!may_link_(neighbour->second, point, gap * step.column, gap * step.row)) {
                return false;
            }
            ++linked;
        }
        return linked > 0;
    }

    bool grow_by_one_ring() {
        for (int gap = 1; gap <= options_.max_gap; ++gap) {
            bool has_grown = false;
            for (const LatticeCell& cell : frontier(gap)) has_grown |= fill(cell, gap);
            if (has_grown) return true;
            // What bridges a gap must stand on more than the seed.
            if (static_cast<int>(lattice_.size()) < options_.min_nodes) return false;
        }
        return false;
    }

    bool fill(const LatticeCell& cell, int gap) {
        const auto expected = predict(lattice_, points_.points_px(), cell);
        if (!expected) return false;
        const double step_px =
            std::min(expected->column_step_px.norm(), expected->row_step_px.norm());
        for (const std::size_t point : points_.within(expected->px, options_.tolerance * step_px)) {
            if (is_used_[point] || !links_to_neighbours(cell, point, gap)) continue;
            add(cell, point);
            return true;
        }
        return false;
    }

    const PointGrid& points_;
    const LinkTest& may_link_;
    const LatticeOptions& options_;
    std::vector<bool> is_used_;
    Lattice lattice_;
};

/// Removes nodes that lie off where their neighbours put them, the worst first.
void remove_misplaced(Lattice& lattice, const std::vector<Eigen::Vector2d>& points_px,
                      double max_share) {
    while (lattice.size() > 4) {
        auto worst = lattice.end();
        double worst_share = max_share;
        for (auto node = lattice.begin(); node != lattice.end(); ++node) {
            const auto expected = predict(lattice, points_px, node->first);
            if (!expected) continue;
            const double step_px =
                std::min(expected->column_step_px.norm(), expected->row_step_px.norm());
            const double share = (points_px[node->second] - expected->px).norm() / step_px;
            if (share > worst_share) {
                worst_share = share;
                worst = node;
            }
        }
        if (worst == lattice.end()) return;
        lattice.erase(worst);
    }
}

/// A node that hardly holds on to the others may be a chance hit: two neighbours are the least, and
/// a corner of the pattern has as many.
void remove_loose(Lattice& lattice) {
    constexpr int kLeastNeighbours = 2;
    for (bool is_done = false; !is_done;) {
        const std::size_t before = lattice.size();
        std::erase_if(lattice, [&](const auto& node) {
            return std::count_if(kUnitSteps.begin(), kUnitSteps.end(), [&](const auto& step) {
                       return lattice.contains(moved(node.first, step));
                   }) < kLeastNeighbours;
        });
        is_done = lattice.size() == before;
    }
}

/// Chance hits hang together by threads; even three by three nodes have 2.67 neighbours each.
bool is_dense(const Lattice& lattice) {
    std::ptrdiff_t neighbours = 0;
    for (const auto& [cell, point] : lattice) {
        neighbours += std::count_if(
            kUnitSteps.begin(), kUnitSteps.end(),
            [&, at = cell](const auto& step) { return lattice.contains(moved(at, step)); });
    }
    constexpr double kLeastMeanNeighbours = 2.5;
    return static_cast<double>(neighbours) >=
           kLeastMeanNeighbours * static_cast<double>(lattice.size());
}

/// Nodes that hold together by steps of at most `max_gap`, the most numerous such part.
Lattice largest_connected(const Lattice& lattice, int max_gap) {
    Lattice largest;
    std::set<LatticeCell> seen;
    for (const auto& [start, ignored] : lattice) {
        if (!seen.insert(start).second) continue;
        Lattice part;
        std::vector<LatticeCell> open{start};
        while (!open.empty()) {
            const LatticeCell cell = open.back();
            open.pop_back();
            part[cell] = lattice.at(cell);
            for (const LatticeCell& step : kUnitSteps) {
                for (int gap = 1; gap <= max_gap; ++gap) {
                    const LatticeCell next = moved(cell, step, gap);
                    if (lattice.contains(next) && seen.insert(next).second) open.push_back(next);
                }
            }
        }
        if (part.size() > largest.size()) largest = std::move(part);
    }
    return largest;
}

/// Values of the polynomial's terms at an offset: a plane, with the second degree behind it.
Eigen::Matrix<double, 6, 1> terms_at(double column, double row) {
    return {1, column, row, column * column, column * row, row * row};
}

/// A polynomial of second degree where the nodes around determine it, else a plane.
int terms_supported(const std::vector<LatticeCell>& offsets) {
    std::set<int> columns;
    std::set<int> rows;
    for (const LatticeCell& offset : offsets) {
        columns.insert(offset.column);
        rows.insert(offset.row);
    }
    constexpr std::size_t kNodesForSecondDegree = 9;
    if (offsets.size() >= kNodesForSecondDegree && columns.size() >= 3 && rows.size() >= 3) {
        return 6;
    }
    return offsets.size() >= 3 && columns.size() >= 2 && rows.size() >= 2 ? 3 : 0;
}

/// Nodes around a cell: where they lie from it in the lattice, and in the picture.
struct NodesAround {
    std::vector<LatticeCell> offsets;
    std::vector<Eigen::Vector2d> seen_px;
};

/// Those that may be used, row by row.
template <class MayUse>
NodesAround nodes_around(const Lattice& lattice, const std::vector<Eigen::Vector2d>& points_px,
                         const LatticeCell& cell, const MayUse& may_use) {
    constexpr int kReach = 3;
    NodesAround nodes;
    for (int row = -kReach; row <= kReach; ++row) {
        for (int column = -kReach; column <= kReach; ++column) {
            if (!may_use(LatticeCell{column, row})) continue;
            const auto node = lattice.find({cell.column + column, cell.row + row});
            if (node == lattice.end()) continue;
            nodes.offsets.push_back({column, row});
            nodes.seen_px.push_back(points_px[node->second]);
        }
    }
    return nodes;
}

std::optional<LatticePrediction> fit_to(const NodesAround& nodes) {
    const auto& [offsets, seen_px] = nodes;
    const int terms = terms_supported(offsets);
    if (terms == 0) return std::nullopt;
    const auto count = static_cast<Eigen::Index>(offsets.size());
    Eigen::MatrixXd design(count, terms);
    Eigen::MatrixXd targets(count, 2);
    for (Eigen::Index index = 0; index < count; ++index) {
        const LatticeCell& offset = offsets[static_cast<std::size_t>(index)];
        const double distance2 = offset.column * offset.column + offset.row * offset.row;
        const double weight = 1.0 / (0.5 + distance2);
        design.row(index) = weight * terms_at(offset.column, offset.row).head(terms).transpose();
        targets.row(index) = weight * seen_px[static_cast<std::size_t>(index)].transpose();
    }
    const auto decomposition = design.colPivHouseholderQr();
    if (decomposition.rank() < terms) return std::nullopt;
    const Eigen::MatrixXd solution = decomposition.solve(targets);
    return LatticePrediction{solution.row(0).transpose(), solution.row(1).transpose(),
                             solution.row(2).transpose()};
}

}  // namespace

std::optional<LatticePrediction> predict(const Lattice& lattice,
                                         const std::vector<Eigen::Vector2d>& points_px,
                                         const LatticeCell& cell) {
    return fit_to(nodes_around(lattice, points_px, cell, [](const LatticeCell& offset) {
        return offset.column != 0 || offset.row != 0;
    }));
}

std::optional<LatticePrediction> fit_around(const Lattice& lattice,
                                            const std::vector<Eigen::Vector2d>& points_px,
                                            const LatticeCell& cell) {
    return fit_to(nodes_around(lattice, points_px, cell, [](const LatticeCell&) { return true; }));
}

LatticeExtent extent_of(const Lattice& lattice) {
    LatticeExtent extent{lattice.begin()->first, lattice.begin()->first};
    for (const auto& [cell, point] : lattice) {
        extent.first = {std::min(extent.first.column, cell.column),
                        std::min(extent.first.row, cell.row)};
        extent.last = {std::max(extent.last.column, cell.column),
                       std::max(extent.last.row, cell.row)};
    }
    return extent;
}

Lattice largest_lattice(const PointGrid& points, const LinkTest& may_link,
                        const LatticeOptions& options) {
    const std::size_t count = points.points_px().size();
    Lattice largest;
    std::vector<bool> is_explained(count, false);
    for (std::size_t at = 0; at < count; ++at) {
        if (is_explained[at]) continue;
        const auto seed = seed_at(points, may_link, at, options.tolerance);
        if (!seed) continue;
        Lattice lattice = Growth(points, may_link, options).from(*seed);
        if (static_cast<int>(lattice.size()) < options.min_nodes) continue;
        remove_misplaced(lattice, points.points_px(), options.max_misplacement);
        remove_loose(lattice);
        lattice = largest_connected(lattice, options.max_gap);
        for (const auto& [cell, point] : lattice) is_explained[point] = true;
        if (lattice.size() > largest.size() && is_dense(lattice)) largest = std::move(lattice);
    }
    if (static_cast<int>(largest.size()) < options.min_nodes) largest.clear();
    return largest;
}

}  // namespace lumi
