// SPDX-License-Identifier: Apache-2.0
// Binary glTF 2.0 (Khronos 2021): a header, a chunk of JSON that describes, a chunk of bytes that it points
// into.
#include "mesh/mesh_formats.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace vs::mesh {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t kByteChunk = 0x004E4942; // "BIN"
static_assert(std::endian::native == std::endian::little);

// glTF's axes from LPS ones: left to +X, superior up (+Y), anterior to the front (+Z).
glm::vec3 turned(glm::vec3 lps) { return {lps.x, lps.z, -lps.y}; }

// Colours of materials are linear.
double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

class Glb {
public:
    Glb() {
        json_ = {{"asset", {{"version", "2.0"}, {"generator", "Volume Studio"}}},
                 {"scene", 0},
                 {"scenes", Json::array({{{"nodes", Json::array()}}})}};
        for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews", "buffers"}) {
            json_[list] = Json::array();
        }
    }

    void add(const Mesh& mesh) {
        std::vector<glm::vec3> points;
        std::vector<glm::vec3> normals;
        glm::vec3 lo(std::numeric_limits<float>::max());
        glm::vec3 hi(-lo);
        for (const glm::vec3 point : mesh.points) {
            points.push_back(turned(point) / 1000.0F);
            lo = glm::min(lo, points.back());
            hi = glm::max(hi, points.back());
        }
        for (const glm::vec3 normal : normalsOf(mesh)) {
            normals.push_back(turned(normal));
        }
        const int position = addArray(points, kArrayBuffer, kFloat, "VEC3", points.size());
        json_["accessors"].back()["min"] = {lo.x, lo.y, lo.z};
        json_["accessors"].back()["max"] = {hi.x, hi.y, hi.z};
        const int normal = addArray(normals, kArrayBuffer, kFloat, "VEC3", normals.size());
        const int corners =
            addArray(mesh.triangles, kElementArrayBuffer, kUnsignedInt, "SCALAR", 3 * mesh.triangles.size());
        Json attributes{{"POSITION", position}, {"NORMAL", normal}};
        if (!mesh.colours.empty()) {
            std::vector<glm::vec3> colours;
            for (const glm::vec3 c : mesh.colours) {
                colours.emplace_back(linear(c.r), linear(c.g), linear(c.b));
            }
            attributes["COLOR_0"] = addArray(colours, kArrayBuffer, kFloat, "VEC3", colours.size());
        }
        const auto number = json_["meshes"].size();
        json_["materials"].push_back(materialOf(mesh));
        json_["meshes"].push_back(
            {{"name", mesh.name},
             {"primitives",
              {{{"attributes", std::move(attributes)}, {"indices", corners}, {"material", number}}}}});
        json_["nodes"].push_back({{"name", mesh.name}, {"mesh", number}});
        json_["scenes"][0]["nodes"].push_back(number);
    }

    std::vector<std::byte> file() {
        json_["buffers"].push_back({{"byteLength", bytes_.size()}});
        std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        constexpr std::size_t head = 12;
        constexpr std::size_t chunkHead = 8;
        const std::size_t total = head + 2 * chunkHead + text.size() + bytes_.size();
        if (total > std::numeric_limits<std::uint32_t>::max()) {
            throw std::length_error("more than 4 GiB");
        }
        std::vector<std::byte> file(total);
        const std::array<std::uint32_t, 5> start{kMagic, 2, std::uint32_t(total), std::uint32_t(text.size()),
                                                 kJsonChunk};
        const std::array<std::uint32_t, 2> between{std::uint32_t(bytes_.size()), kByteChunk};
        std::byte* end = put(file.data(), std::as_bytes(std::span(start)));
        end = put(end, std::as_bytes(std::span(text)));
        end = put(end, std::as_bytes(std::span(between)));
        put(end, bytes_);
        return file;
    }

private:
    static std::byte* put(std::byte* at, std::span<const std::byte> bytes) {
        return std::copy(bytes.begin(), bytes.end(), at);
    }

    static Json materialOf(const Mesh& mesh) {
        // The colours of points are multiplied by this one.
        const glm::dvec3 c = mesh.colours.empty() ? mesh.colour : glm::dvec3(1);
        Json material{{"name", mesh.name},
                      {"pbrMetallicRoughness",
                       {{"baseColorFactor", {linear(c.r), linear(c.g), linear(c.b), mesh.opacity}},
                        {"metallicFactor", 0.0},
                        {"roughnessFactor", 0.6}}}};
        if (mesh.opacity < 1) {
            material["alphaMode"] = "BLEND";
        }
        return material;
    }

    // All elements are of 4 bytes, so every array begins where it may.
    template <typename T>
    int addArray(const std::vector<T>& values, int target, int component, const char* type,
                 std::size_t count) {
        const auto bytes = std::as_bytes(std::span(values));
        json_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}, {"target", target}});
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", component},
                                      {"count", count},
                                      {"type", type}});
        return int(json_["accessors"].size()) - 1;
    }

    Json json_;
    std::vector<std::byte> bytes_;
};

} // namespace

std::vector<std::byte> glbBytes(std::span<const Mesh> meshes) {
    Glb glb;
    for (const Mesh& mesh : meshes) {
        if (!mesh.triangles.empty()) { // an array without elements is not allowed
            glb.add(mesh);
        }
    }
    return glb.file();
}

} // namespace vs::mesh
