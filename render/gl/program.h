#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/object_name.h"

namespace lumi {

void delete_program(unsigned name);

/// A vertex and a fragment shader, linked.
///
/// Both are compiled from the same text, with LUMI_VERTEX or LUMI_FRAGMENT defined; `#version` and
/// the default precisions are put before it to suit the current context.
class Program {
 public:
    Program() = default;
    /// `name` is for messages; `definitions` are lines such as "LAYERS 4". The sources follow each
    /// other. Throws Error (E-GL-SHADER) with the driver's log.
    Program(const std::string& name, const std::vector<std::string_view>& sources,
            const std::vector<std::string>& definitions = {});

    void use() const;
    /// The program must be in use. A uniform that the compiler dropped is ignored.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const glm::vec2& value) const;
    void set(const char* uniform, const glm::vec3& value) const;
    void set(const char* uniform, const glm::vec4& value) const;
    void set(const char* uniform, const glm::mat4& value) const;
    void set(const char* uniform, const std::vector<glm::vec4>& values) const;

 private:
    ObjectName<delete_program> name_;
};

}  // namespace lumi
