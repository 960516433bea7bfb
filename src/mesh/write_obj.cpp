// SPDX-License-Identifier: Apache-2.0
#include "mesh/mesh_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace vs::mesh {

namespace {

// A name that no reader of OBJ takes apart: they end at white space.
std::string wordOf(const Mesh& mesh, std::size_t number) {
    std::string word = mesh.name.empty() ? fmt::format("surface_{}", number + 1) : mesh.name;
    std::replace_if(
        word.begin(), word.end(), [](unsigned char c) { return c <= ' ' || c == 127; }, '_');
    return word;
}

// Materials of their own, also where names are the same.
std::string materialOf(const Mesh& mesh, std::size_t number) {
    return fmt::format("{}_{}", wordOf(mesh, number), number + 1);
}

} // namespace

std::string objText(std::span<const Mesh> meshes, const std::string& materials) {
    std::string text = fmt::format("# {}\nmtllib {}\n", kSpaceNote, materials);
    const auto out = std::back_inserter(text);
    std::size_t first = 1; // points are counted through all objects
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Mesh& mesh = meshes[i];
        fmt::format_to(out, "o {}\nusemtl {}\n", wordOf(mesh, i), materialOf(mesh, i));
        for (std::size_t n = 0; n < mesh.points.size(); ++n) {
            const glm::vec3 p = mesh.points[n];
            fmt::format_to(out, "v {} {} {}", p.x, p.y, p.z);
            if (!mesh.colours.empty()) {
                const glm::vec3 c = mesh.colours[n];
                fmt::format_to(out, " {:.4f} {:.4f} {:.4f}", c.r, c.g, c.b);
            }
            text += '\n';
        }
        for (const glm::vec3 n : normalsOf(mesh)) {
            fmt::format_to(out, "vn {:.4f} {:.4f} {:.4f}\n", n.x, n.y, n.z);
        }
        for (const glm::uvec3 t : mesh.triangles) {
            const std::size_t a = first + t.x;
            const std::size_t b = first + t.y;
            const std::size_t c = first + t.z;
            fmt::format_to(out, "f {}//{} {}//{} {}//{}\n", a, a, b, b, c, c);
        }
        first += mesh.points.size();
    }
    return text;
}

std::string mtlText(std::span<const Mesh> meshes) {
    std::string text = "# Volume Studio\n";
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Mesh& mesh = meshes[i];
        text += fmt::format("newmtl {}\nKd {:.4f} {:.4f} {:.4f}\nKs 0.1 0.1 0.1\nNs 30\nd {:.4f}\nillum 2\n",
                            materialOf(mesh, i), mesh.colour.r, mesh.colour.g, mesh.colour.b, mesh.opacity);
    }
    return text;
}

} // namespace vs::mesh
