#pragma once

namespace lumi {

/// Ceres tells of every step that it had to shorten, on stderr, where libraries say nothing. To be
/// called before it solves; its return values tell the same.
void silence_ceres();

}  // namespace lumi
