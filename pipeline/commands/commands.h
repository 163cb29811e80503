#pragma once

#include <CLI/App.hpp>

#include "pipeline/commands/command_context.h"

namespace lumi {

/// Each adds one command (or one family of commands) to the command line. What the user asks for is
/// left in `context.chosen`, so that nothing runs before the whole line has been understood.
void add_build_command(CLI::App& app, CommandContext& context);
void add_calibrate_command(CLI::App& app, CommandContext& context);
void add_bench_boards_command(CLI::App& app, CommandContext& context);
void add_stage_commands(CLI::App& app, CommandContext& context);
void add_regression_command(CLI::App& app, CommandContext& context);
void add_doctor_command(CLI::App& app, CommandContext& context);
void add_render_command(CLI::App& app, CommandContext& context);
void add_view_command(CLI::App& app, CommandContext& context);
void add_bench_command(CLI::App& app, CommandContext& context);
void add_bench_depth_command(CLI::App& app, CommandContext& context);
void add_bench_poses_command(CLI::App& app, CommandContext& context);
void add_bench_flicker_command(CLI::App& app, CommandContext& context);
void add_bench_hazards_command(CLI::App& app, CommandContext& context);
void add_bench_mesh_command(CLI::App& app, CommandContext& context);
void add_bench_orbit_command(CLI::App& app, CommandContext& context);
void add_bench_rivals_command(CLI::App& app, CommandContext& context);
void add_evaluate_command(CLI::App& app, CommandContext& context);
void add_select_command(CLI::App& app, CommandContext& context);
void add_plan_command(CLI::App& app, CommandContext& context);
void add_chart_command(CLI::App& app, CommandContext& context);
void add_compare_evaluations_command(CLI::App& app, CommandContext& context);
void add_compare_pictures_command(CLI::App& app, CommandContext& context);
void add_compare_poses_command(CLI::App& app, CommandContext& context);
void add_fuse_command(CLI::App& app, CommandContext& context);
void add_gallery_command(CLI::App& app, CommandContext& context);
void add_inspect_command(CLI::App& app, CommandContext& context);
void add_validate_command(CLI::App& app, CommandContext& context);
void add_stress_command(CLI::App& app, CommandContext& context);
void add_synth_command(CLI::App& app, CommandContext& context);

/// A subcommand whose help begins with `example`.
CLI::App& add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::string& example);

}  // namespace lumi
