#include "render/paths/tour_through_views.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/paths/photograph_eye.h"
#include "render/paths/pose_curve.h"
#include "render/transfer/view_geometry.h"

namespace lumi {
namespace {

/// Of each piece of the curve.
constexpr int kSamples = 256;

using Step = Eigen::Matrix<double, 6, 1>;

/// From one pose to the next, in the world: the way, and the turn as a way.
Step step_between(const Rigid3& from, const Rigid3& to, double length_per_rad) {
    const Eigen::AngleAxisd turn(to.rotation.conjugate() * from.rotation);
    Step step;
    step << centre_in_world(to) - centre_in_world(from),
        length_per_rad * turn.angle() * turn.axis();
    return step;
}

std::vector<Step> steps_along(const PoseCurve& curve, double length_per_rad) {
    std::vector<Step> steps;
    Rigid3 last = curve.at(0);
    for (std::size_t i = 1; i <= curve.pieces() * kSamples; ++i) {
        const Rigid3 next = curve.at(static_cast<double>(i) / kSamples);
        steps.push_back(step_between(last, next, length_per_rad));
        last = next;
    }
    return steps;
}

double angle_between(const Step& from, const Step& to) {
    const double product = from.norm() * to.norm();
    return product > 0 ? std::acos(std::clamp(from.dot(to) / product, -1.0, 1.0)) : 0.0;
}

/// The squares of the highest speeds at the ends of steps that accelerations allow: v^2 times the
/// curvature sideways, and from each to the next no more than v^2 + 2 a s, either way.
std::vector<double> squared_speeds(const std::vector<Step>& steps, double full_speed,
                                   double acceleration) {
    std::vector<double> squares(steps.size() + 1, full_speed * full_speed);
    squares.front() = 0;
    squares.back() = 0;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        const double angle = angle_between(steps[i - 1], steps[i]);
        const double length = 0.5 * (steps[i - 1].norm() + steps[i].norm());
        if (angle > 0) squares[i] = std::min(squares[i], acceleration * length / angle);
    }
    for (std::size_t i = 0; i < steps.size(); ++i)
        squares[i + 1] = std::min(squares[i + 1], squares[i] + 2 * acceleration * steps[i].norm());
    for (std::size_t i = steps.size(); i-- > 0;)
        squares[i] = std::min(squares[i], squares[i + 1] + 2 * acceleration * steps[i].norm());
    return squares;
}

/// When the ends of steps are reached, and at what speed.
struct Schedule {
    std::vector<double> times;
    std::vector<double> speeds;
};

Schedule schedule_of(const std::vector<Step>& steps, double mean_piece) {
    Schedule schedule{{0.0}, {}};
    for (const double square : squared_speeds(steps, mean_piece, mean_piece))
        schedule.speeds.push_back(std::sqrt(square));
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double speeds = schedule.speeds[i] + schedule.speeds[i + 1];
        schedule.times.push_back(schedule.times[i] +
                                 (speeds > 0 ? 2 * steps[i].norm() / speeds : 0));
    }
    return schedule;
}

/// Where on the curve it is at a time: within a step it is accelerated evenly.
double place_at(const Schedule& schedule, double time) {
    const auto next = std::upper_bound(schedule.times.begin(), schedule.times.end(), time);
    if (next == schedule.times.end())
        return static_cast<double>(schedule.times.size() - 1) / kSamples;
    const auto step = static_cast<std::size_t>(next - schedule.times.begin()) - 1;
    const double whole = schedule.times[step + 1] - schedule.times[step];
    const double part = (time - schedule.times[step]) / whole;
    const double from = schedule.speeds[step];
    const double to = schedule.speeds[step + 1];
    const double share = part * (from + 0.5 * (to - from) * part) / (0.5 * (from + to));
    return (static_cast<double>(step) + std::clamp(share, 0.0, 1.0)) / kSamples;
}

}  // namespace

std::vector<Eye> tour_through_views(const Lumigraph& lumigraph, int count, int width_px,
                                    int height_px) {
    std::vector<Rigid3> poses;
    for (const LumigraphView& view : lumigraph.views) poses.push_back(eye_at(view).cam_from_world);
    const Camera camera = fitted_to(eye_at(lumigraph.views.front()), width_px, height_px).camera;
    const InverseDepthRange scene = scene_inverse_depths(lumigraph);
    const double middle_depth = 2 / (scene.near + scene.far);
    const PoseCurve curve(poses, middle_depth);
    const std::vector<Step> steps = steps_along(curve, middle_depth);
    const double way =
        std::accumulate(steps.begin(), steps.end(), 0.0,
                        [](double sum, const Step& step) { return sum + step.norm(); });
    const Schedule schedule =
        schedule_of(steps, way / static_cast<double>(std::max<std::size_t>(curve.pieces(), 1)));
    std::vector<Eye> tour;
    for (int i = 0; i < count; ++i) {
        const double along = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        tour.push_back({camera, curve.at(place_at(schedule, along * schedule.times.back()))});
    }
    return tour;
}

}  // namespace lumi
