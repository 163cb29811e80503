#include "pipeline/commands/video_file.h"

#include <string>
#include <utility>
#include <vector>

#include "calib/work/child_process.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAdvice =
    "install ffmpeg, or let --out name a folder: frames become PNG files";
/// Nothing ends later, but what hangs.
constexpr double kStartLimit_s = 600;
constexpr double kFrameLimit_s = 10;
constexpr const char* kConstantQuality = "18";  // Visually lossless for most pictures.

[[noreturn]] void refuse(const fs::path& video, const std::string& reason) {
    throw Error(ErrorKind::kExternalProgram, "E-VIDEO-WRITE", video.string() + ": " + reason,
                kAdvice);
}

/// ffmpeg reads its pattern in all of a path.
std::string as_pattern(const fs::path& folder) {
    std::string pattern;
    for (const char c : folder.string()) pattern += c == '%' ? "%%" : std::string(1, c);
    return pattern;
}

/// What the program printed. Throws Error (E-VIDEO-WRITE) when it did not end well.
std::string output_of(std::vector<std::string> arguments, std::size_t frames, const fs::path& log,
                      const fs::path& video, const Progress& progress) {
    ChildCommand command;
    command.arguments = std::move(arguments);
    command.time_limit_s = kStartLimit_s + kFrameLimit_s * static_cast<double>(frames);
    command.log_path = log;
    command.missing_advice = kAdvice;
    const ChildResult result = run_child(command, progress);
    std::string output = read_whole_text(log);
    if (result.end != ChildEnd::kExited || result.exit_status != 0)
        refuse(video, command.arguments.front() + " ended with " + description_of(result, command) +
                          ": " + output);
    return output;
}

}  // namespace

void write_video(const fs::path& frames_folder, std::size_t count, double frames_per_second,
                 const fs::path& video, const Progress& progress) {
    const fs::path made = frames_folder / "video.mp4";
    const fs::path log = frames_folder / "video.log";
    output_of({"ffmpeg",
               "-nostdin",
               "-y",
               "-loglevel",
               "error",
               "-framerate",
               std::to_string(frames_per_second),
               "-start_number",
               "1",
               "-i",
               as_pattern(frames_folder) + "/frame-%06d.png",
               "-vf",
               "pad=ceil(iw/2)*2:ceil(ih/2)*2",
               "-c:v",
               "libx264",
               "-crf",
               kConstantQuality,
               "-pix_fmt",
               "yuv420p",
               "-movflags",
               "+faststart",
               made.string()},
              count, log, video, progress);
    // An exit status is no evidence.
    const std::string counted =
        output_of({"ffprobe", "-v", "error", "-count_packets", "-select_streams", "v:0",
                   "-show_entries", "stream=nb_read_packets", "-of", "csv=p=0", made.string()},
                  count, log, video, progress);
    if (counted != std::to_string(count) + "\n")
        refuse(video, "ffmpeg made a video of \"" + counted.substr(0, counted.find('\n')) +
                          "\" frames of " + std::to_string(count));
    put_whole_file(made, video);
}

}  // namespace lumi
