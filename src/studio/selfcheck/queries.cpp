// SPDX-License-Identifier: Apache-2.0
#include "studio/selfcheck/queries.h"

#include "gl/pass.h"
#include "studio/shaders/bindings.h"

namespace vs::studio {

std::vector<glm::vec4> answersOf(gl::Program& program, std::span<const glm::vec4> queries) {
    const gl::Pass pass("answer queries");
    gl::Buffer in(queries.size_bytes(), "self check queries");
    const gl::Buffer out(queries.size_bytes(), "self check answers");
    in.write(queries);
    in.bindStorage(kQueriesStorage);
    out.bindStorage(kAnswersStorage);
    program.set("count", int(queries.size()));
    program.dispatchOver({int(queries.size()), 1, 1}, gl::Barrier::All);
    return out.read<glm::vec4>(queries.size());
}

} // namespace vs::studio
