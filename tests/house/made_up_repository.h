#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace lumi {

/// A repository of made-up files, gone at the end of its test.
class MadeUpRepository {
 public:
    MadeUpRepository() {
        std::string name = (std::filesystem::temp_directory_path() / "lumi-house-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        root_ = name;
    }
    ~MadeUpRepository() { std::filesystem::remove_all(root_); }
    MadeUpRepository(const MadeUpRepository&) = delete;
    MadeUpRepository& operator=(const MadeUpRepository&) = delete;

    void write(const std::filesystem::path& file, const std::string& text) const {
        std::filesystem::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
    }
    [[nodiscard]] const std::filesystem::path& root() const { return root_; }

 private:
    std::filesystem::path root_;
};

}  // namespace lumi
