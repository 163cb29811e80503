#include "calib/colmap/colmap_database.h"

#include <sqlite3.h>

#include <array>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>

#include "calib/work/error.h"

namespace lumi {
namespace {

// COLMAP's pair_id = kMaxImages * smaller image id + larger image id (base/database.cc).
constexpr sqlite3_int64 kMaxImages = 2147483647;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what,
                         ErrorKind kind = ErrorKind::kExternalProgram) {
    throw Error(kind, "E-COLMAP-DATABASE", path.string() + ": " + what,
                kind == ErrorKind::kResources
                    ? "free some disk space and run the same command again"
                    : "run the same command again; if it happens again, check the disk and the "
                      "version of COLMAP (3.8 is expected)");
}

class Database {
 public:
    Database(const std::filesystem::path& path, int flags) : path_(path) {
        if (sqlite3_open_v2(path.c_str(), &handle_, flags, nullptr) != SQLITE_OK) {
            const std::string reason = sqlite3_errmsg(handle_);
            sqlite3_close(handle_);
            refuse(path_, reason);
        }
    }
    ~Database() { sqlite3_close(handle_); }
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    void execute(const char* sql) { expect(sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr)); }
    void expect(int code) const {
        if (code == SQLITE_OK || code == SQLITE_DONE || code == SQLITE_ROW) return;
        refuse(path_, sqlite3_errmsg(handle_),
               code == SQLITE_FULL ? ErrorKind::kResources : ErrorKind::kExternalProgram);
    }
    [[nodiscard]] sqlite3* handle() const { return handle_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
    sqlite3* handle_ = nullptr;
};

class Statement {
 public:
    Statement(Database& database, const char* sql) : database_(database) {
        database.expect(sqlite3_prepare_v2(database.handle(), sql, -1, &handle_, nullptr));
    }
    ~Statement() { sqlite3_finalize(handle_); }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    Statement& bind(int index, sqlite3_int64 value) {
        database_.expect(sqlite3_bind_int64(handle_, index, value));
        return *this;
    }
    Statement& bind(int index, const std::string& text) {
        database_.expect(sqlite3_bind_text(handle_, index, text.c_str(), -1, SQLITE_TRANSIENT));
        return *this;
    }
    Statement& bind(int index, std::span<const std::byte> bytes) {
        // A null pointer would bind NULL instead of nothing.
        database_.expect(bytes.empty() ? sqlite3_bind_zeroblob(handle_, index, 0)
                                       : sqlite3_bind_blob64(handle_, index, bytes.data(),
                                                             bytes.size(), SQLITE_TRANSIENT));
        return *this;
    }
    void run_once() {
        database_.expect(sqlite3_step(handle_));
        database_.expect(sqlite3_reset(handle_));
    }
    bool next_row() {
        const int code = sqlite3_step(handle_);
        database_.expect(code);
        return code == SQLITE_ROW;
    }
    [[nodiscard]] sqlite3_int64 integer(int column) const {
        return sqlite3_column_int64(handle_, column);
    }
    [[nodiscard]] std::span<const std::byte> blob(int column) const {
        const auto* const data =
            static_cast<const std::byte*>(sqlite3_column_blob(handle_, column));
        const int size = sqlite3_column_bytes(handle_, column);
        return {data, data == nullptr ? std::size_t{0} : static_cast<std::size_t>(size)};
    }

 private:
    Database& database_;
    sqlite3_stmt* handle_ = nullptr;
};

void write_cameras(Database& database, const std::vector<ColmapCamera>& cameras) {
    Statement insert(database,
                     "INSERT INTO cameras (camera_id, model, width, height, params, "
                     "prior_focal_length) VALUES (?, ?, ?, ?, ?, ?)");
    for (std::size_t index = 0; index < cameras.size(); ++index) {
        const Camera& camera = cameras[index].camera;
        insert.bind(1, static_cast<sqlite3_int64>(index + 1))
            .bind(2, static_cast<sqlite3_int64>(camera.model))
            .bind(3, static_cast<sqlite3_int64>(camera.width_px))
            .bind(4, static_cast<sqlite3_int64>(camera.height_px))
            .bind(5, std::as_bytes(std::span(camera.parameters)))
            .bind(6, static_cast<sqlite3_int64>(cameras[index].focal_length_is_known))
            .run_once();
    }
}

void write_photographs(Database& database, const std::vector<ColmapPhotograph>& photographs,
                       KeypointsIn keypoints_in) {
    static_assert(sizeof(Eigen::Vector2f) == 2 * sizeof(float));
    Statement image(database, "INSERT INTO images (image_id, name, camera_id) VALUES (?, ?, ?)");
    Statement keypoints(database,
                        "INSERT INTO keypoints (image_id, rows, cols, data) VALUES (?, ?, 2, ?)");
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        const ColmapPhotograph& photograph = photographs[index];
        const auto id = static_cast<sqlite3_int64>(index + 1);
        image.bind(1, id)
            .bind(2, colmap_image_name(static_cast<int>(index)))
            .bind(3, static_cast<sqlite3_int64>(photograph.camera_index + 1))
            .run_once();
        if (keypoints_in == KeypointsIn::kNothing) continue;
        keypoints.bind(1, id)
            .bind(2, static_cast<sqlite3_int64>(photograph.keypoints_px.size()))
            .bind(3, std::as_bytes(std::span(photograph.keypoints_px)))
            .run_once();
    }
}

VerifiedPair read_pair(const Database& database, const Statement& row,
                       const std::vector<ColmapPhotograph>& photographs) {
    const sqlite3_int64 pair_id = row.integer(0);
    const sqlite3_int64 first_id = pair_id / kMaxImages;
    const sqlite3_int64 second_id = pair_id % kMaxImages;
    const auto count = static_cast<sqlite3_int64>(photographs.size());
    if (first_id < 1 || second_id <= first_id || second_id > count) {
        refuse(database.path(), "a pair of photographs that do not exist");
    }
    VerifiedPair pair;
    pair.first = static_cast<int>(first_id - 1);
    pair.second = static_cast<int>(second_id - 1);
    pair.configuration = static_cast<PairConfiguration>(row.integer(3));
    const std::span<const std::byte> data = row.blob(2);
    const sqlite3_int64 rows = row.integer(1);
    static_assert(sizeof(FeatureMatch) == 2 * sizeof(std::uint32_t));
    if (rows < 0 || data.size() != static_cast<std::size_t>(rows) * sizeof(FeatureMatch)) {
        refuse(database.path(), "a list of matches of the wrong size");
    }
    pair.inliers.resize(static_cast<std::size_t>(rows));
    if (!data.empty()) std::memcpy(pair.inliers.data(), data.data(), data.size());
    const std::size_t first_size =
        photographs[static_cast<std::size_t>(pair.first)].keypoints_px.size();
    const std::size_t second_size =
        photographs[static_cast<std::size_t>(pair.second)].keypoints_px.size();
    for (const FeatureMatch& match : pair.inliers) {
        if (match.first >= first_size || match.second >= second_size) {
            refuse(database.path(), "a match of features that do not exist");
        }
    }
    return pair;
}

}  // namespace

std::string colmap_image_name(int photograph_index) {
    std::array<char, 24> name{};
    std::snprintf(name.data(), name.size(), "%06d.png", photograph_index + 1);
    return name.data();
}

std::optional<int> photograph_index_of(const std::string& colmap_image_name_text) {
    int number = 0;
    const char* const begin = colmap_image_name_text.data();
    const auto [end, error] = std::from_chars(begin, begin + colmap_image_name_text.size(), number);
    static_cast<void>(end);
    if (error != std::errc() || number < 1) return std::nullopt;
    if (colmap_image_name(number - 1) != colmap_image_name_text) return std::nullopt;
    return number - 1;
}

void fill_colmap_database(const std::filesystem::path& path,
                          const std::vector<ColmapCamera>& cameras,
                          const std::vector<ColmapPhotograph>& photographs, KeypointsIn keypoints) {
    Database database(path, SQLITE_OPEN_READWRITE);
    database.execute("BEGIN");
    write_cameras(database, cameras);
    write_photographs(database, photographs, keypoints);
    database.execute("COMMIT");
}

void write_verified_pairs(const std::filesystem::path& path,
                          const std::vector<VerifiedPair>& pairs) {
    static_assert(sizeof(FeatureMatch) == 2 * sizeof(std::uint32_t));
    Database database(path, SQLITE_OPEN_READWRITE);
    database.execute("BEGIN");
    Statement insert(database,
                     "INSERT INTO two_view_geometries (pair_id, rows, cols, data, config) "
                     "VALUES (?, ?, 2, ?, ?)");
    for (const VerifiedPair& pair : pairs) {
        insert.bind(1, kMaxImages * (pair.first + 1) + pair.second + 1)
            .bind(2, static_cast<sqlite3_int64>(pair.inliers.size()))
            .bind(3, std::as_bytes(std::span(pair.inliers)))
            .bind(4, static_cast<sqlite3_int64>(pair.configuration))
            .run_once();
    }
    database.execute("COMMIT");
}

void read_keypoints(const std::filesystem::path& path, std::vector<ColmapPhotograph>& photographs) {
    Database database(path, SQLITE_OPEN_READONLY);
    Statement rows(database, "SELECT image_id, rows, cols, data FROM keypoints ORDER BY image_id");
    std::size_t expected_id = 0;
    while (rows.next_row()) {
        ++expected_id;
        const auto id = static_cast<std::size_t>(rows.integer(0));
        if (id != expected_id || id > photographs.size()) {
            refuse(path, "keypoints of photographs that do not exist, or none of some");
        }
        // x, y, and the four of an affine shape.
        const sqlite3_int64 count = rows.integer(1);
        const sqlite3_int64 columns = rows.integer(2);
        const std::span<const std::byte> data = rows.blob(3);
        if (count < 0 || columns < 2 || columns > 6 ||
            data.size() != static_cast<std::size_t>(count * columns) * sizeof(float)) {
            refuse(path, "a list of keypoints of the wrong size");
        }
        std::vector<Eigen::Vector2f>& keypoints = photographs[id - 1].keypoints_px;
        keypoints.resize(static_cast<std::size_t>(count));
        for (std::size_t index = 0; index < keypoints.size(); ++index) {
            std::memcpy(keypoints[index].data(),
                        data.data() + index * static_cast<std::size_t>(columns) * sizeof(float),
                        2 * sizeof(float));
            if (!keypoints[index].allFinite()) refuse(path, "a keypoint that is no number");
        }
    }
    if (expected_id != photographs.size()) refuse(path, "photographs without keypoints");
}

std::vector<VerifiedPair> read_verified_pairs(const std::filesystem::path& path,
                                              const std::vector<ColmapPhotograph>& photographs,
                                              std::size_t expected_pairs) {
    Database database(path, SQLITE_OPEN_READONLY);
    Statement rows(database,
                   "SELECT pair_id, rows, data, config FROM two_view_geometries ORDER BY pair_id");
    std::vector<VerifiedPair> pairs;
    std::size_t judged = 0;
    while (rows.next_row()) {
        ++judged;
        VerifiedPair pair = read_pair(database, rows, photographs);
        const bool has_geometry = pair.configuration != PairConfiguration::kUndefined &&
                                  pair.configuration != PairConfiguration::kDegenerate &&
                                  pair.configuration != PairConfiguration::kWatermark;
        if (has_geometry && !pair.inliers.empty()) pairs.push_back(std::move(pair));
    }
    if (judged != expected_pairs) {
        refuse(path, "COLMAP judged " + std::to_string(judged) + " of " +
                         std::to_string(expected_pairs) + " pairs");
    }
    return pairs;
}

}  // namespace lumi
