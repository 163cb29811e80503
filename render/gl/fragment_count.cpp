#include "render/gl/fragment_count.h"

#include <epoxy/gl.h>

#include "render/gl/object_name.h"

namespace lumi {
namespace {

void delete_query(unsigned name) { glDeleteQueries(1, &name); }

ObjectName<delete_query> new_query() {
    GLuint name = 0;
    glGenQueries(1, &name);
    return ObjectName<delete_query>(name);
}

}  // namespace

std::optional<std::uint64_t> fragment_count(const std::function<void()>& draw) {
    if (!epoxy_is_desktop_gl()) return std::nullopt;
    const ObjectName<delete_query> query = new_query();
    glBeginQuery(GL_SAMPLES_PASSED, query.get());
    draw();
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint count = 0;
    glGetQueryObjectuiv(query.get(), GL_QUERY_RESULT, &count);
    return count;
}

}  // namespace lumi
