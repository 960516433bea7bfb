// SPDX-License-Identifier: Apache-2.0
#include "field/bricks/detail.h"
#include "field/marks/mark_texture.h"
#include "field/scene.h"
#include "gl/embedded_shaders.h"
#include "gl/program.h"
#include "gpu/gl/variants.h"
#include "gpu/gl_test.h"
#include "render/colours/classification.h"
#include "render/rays/occlusion.h"
#include "render/rays/ray_caster.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

namespace vs::gl {
namespace {

using BlockLayoutTest = test::GlTest;

// Every uniform block of the project.
const std::map<std::string, const BlockLayout*> kLayouts{
    {"SceneBlock", &field::kSceneBlockLayout},
    {"BricksBlock", &field::kBricksBlockLayout},
    {"MarksBlock", &field::kMarksBlockLayout},
    {"FillBlock", &field::kFillBlockLayout},
    {"SegmentColoursBlock", &render::kSegmentColoursBlockLayout},
    {"ViewBlock", &render::kViewBlockLayout},
    {"ClassificationBlock", &render::kClassificationBlockLayout},
    {"OcclusionBlock", &render::kOcclusionBlockLayout},
};

// A block as the driver lays it out.
struct DriverBlock {
    struct Member {
        std::size_t offset = 0;
        std::size_t size = 0;
    };
    std::size_t size = 0;
    std::map<std::string, Member> members;
};

// Bytes of one value, where columns of a matrix begin `matrixStride` bytes apart. 0: a type that is not known
// here.
std::size_t sizeOf(GLint type, GLint matrixStride) {
    switch (type) {
    case GL_FLOAT:
    case GL_INT:
    case GL_UNSIGNED_INT:
        return 4;
    case GL_FLOAT_VEC2:
    case GL_INT_VEC2:
        return 8;
    case GL_FLOAT_VEC3:
    case GL_INT_VEC3:
        return 12;
    case GL_FLOAT_VEC4:
    case GL_INT_VEC4:
    case GL_UNSIGNED_INT_VEC4:
        return 16;
    case GL_FLOAT_MAT3:
        return 3 * std::size_t(matrixStride);
    case GL_FLOAT_MAT4:
        return 4 * std::size_t(matrixStride);
    default:
        return 0;
    }
}

std::string nameOf(const Program& program, GLenum interface, GLuint index) {
    std::array<char, 256> text{};
    glGetProgramResourceName(program.name(), interface, index, GLsizei(text.size()), nullptr, text.data());
    const std::string name(text.data());
    return name.substr(0, name.find('[')); // an array is called after its first element
}

template <std::size_t N>
std::array<GLint, N> askFor(const Program& program, GLenum interface, GLuint index,
                            const std::array<GLenum, N>& properties) {
    std::array<GLint, N> values{};
    glGetProgramResourceiv(program.name(), interface, index, N, properties.data(), N, nullptr, values.data());
    return values;
}

DriverBlock::Member memberOf(const Program& program, GLuint uniform) {
    const auto [type, count, offset, arrayStride, matrixStride] = askFor<5>(
        program, GL_UNIFORM, uniform, {GL_TYPE, GL_ARRAY_SIZE, GL_OFFSET, GL_ARRAY_STRIDE, GL_MATRIX_STRIDE});
    const std::size_t size =
        arrayStride > 0 ? std::size_t(count) * std::size_t(arrayStride) : sizeOf(type, matrixStride);
    return {std::size_t(offset), size};
}

// Every uniform block of a program, by its name. A program has all members of a std140 block, used or not.
std::map<std::string, DriverBlock> blocksOf(const Program& program) {
    std::map<std::string, DriverBlock> blocks;
    GLint count = 0;
    glGetProgramInterfaceiv(program.name(), GL_UNIFORM_BLOCK, GL_ACTIVE_RESOURCES, &count);
    for (GLuint block = 0; block < GLuint(count); ++block) {
        DriverBlock& out = blocks[nameOf(program, GL_UNIFORM_BLOCK, block)];
        const auto [size, members] =
            askFor<2>(program, GL_UNIFORM_BLOCK, block, {GL_BUFFER_DATA_SIZE, GL_NUM_ACTIVE_VARIABLES});
        out.size = std::size_t(size);
        std::vector<GLint> uniforms(std::size_t(members), 0);
        const GLenum list = GL_ACTIVE_VARIABLES;
        glGetProgramResourceiv(program.name(), GL_UNIFORM_BLOCK, block, 1, &list, members, nullptr,
                               uniforms.data());
        for (const GLint uniform : uniforms) {
            out.members[nameOf(program, GL_UNIFORM, GLuint(uniform))] = memberOf(program, GLuint(uniform));
        }
    }
    return blocks;
}

// What C++ and the driver do not agree about, one line each.
std::vector<std::string> differences(const BlockLayout& layout, const DriverBlock& block) {
    std::vector<std::string> out;
    auto rest = block.members;
    for (const BlockMember& member : layout.members) {
        const auto found = rest.find(std::string(member.name));
        if (found == rest.end()) {
            out.push_back(fmt::format("{} is not in the shader", member.name));
            continue;
        }
        const auto [offset, size] = found->second;
        if (offset != member.offset || size != member.size) {
            out.push_back(fmt::format("{} is {} bytes at {} in C++, {} bytes at {} in the shader",
                                      member.name, member.size, member.offset, size, offset));
        }
        rest.erase(found);
    }
    for (const auto& [name, member] : rest) {
        out.push_back(fmt::format("{} is not in C++", name));
    }
    if (block.size != layout.size) {
        out.push_back(fmt::format("the block is {} bytes in C++, {} in the shader", layout.size, block.size));
    }
    return out;
}

const std::regex kBlock(R"(uniform\s+(\w+)\s*\{)");

// The names of blocks that shader files declare, whether programs have them or not.
std::set<std::string> declaredBlocks() {
    std::set<std::string> names;
    for (const EmbeddedShader& shader : embeddedShaders()) {
        const std::string source = findShader(std::string(shader.path)).value();
        for (std::sregex_iterator it(source.begin(), source.end(), kBlock), end; it != end; ++it) {
            names.insert((*it)[1].str());
        }
    }
    return names;
}

TEST_F(BlockLayoutTest, EveryBlockOfEveryProgramIsAsItsStruct) {
    std::set<std::string> seen;
    for (const EmbeddedShader& shader : embeddedShaders()) {
        const std::string path(shader.path);
        if (!path.ends_with(".comp")) {
            continue;
        }
        for (const Defines& defines : test::variantsOf(findShader(path).value())) {
            if (!std::regex_search(expandSource(path, defines).text, kBlock)) {
                continue;
            }
            SCOPED_TRACE(test::textOf(path, defines));
            for (const auto& [name, block] : blocksOf(Program(path, defines))) {
                ASSERT_TRUE(kLayouts.contains(name)) << name << " has no BlockLayout in this test";
                EXPECT_EQ(differences(*kLayouts.at(name), block), std::vector<std::string>()) << name;
                seen.insert(name);
            }
        }
    }
    std::set<std::string> known;
    for (const auto& [name, layout] : kLayouts) {
        EXPECT_EQ(layout->name, name);
        EXPECT_TRUE(isWhole(*layout)) << name;
        known.insert(name);
    }
    EXPECT_EQ(seen, known);
    EXPECT_EQ(declaredBlocks(), known);
}

struct MixedBlock {
    glm::vec4 place{0};
    glm::mat4 turn{1};
    glm::ivec4 counts[2]{};
    glm::vec4 loose[4]{};
};
constexpr BlockMember kMixedMembers[] = {
    VS_BLOCK_MEMBER(MixedBlock, place), VS_BLOCK_MEMBER(MixedBlock, turn),
    VS_BLOCK_MEMBER(MixedBlock, counts), VS_BLOCK_MEMBER(MixedBlock, loose)};
constexpr BlockLayout kMixedLayout{"MixedBlock", sizeof(MixedBlock), kMixedMembers};
static_assert(isWhole(kMixedLayout));

DriverBlock mixedBlock() {
    setenv("VOLUME_STUDIO_SHADER_DIR", VS_TEST_SHADERS, 1);
    const Program program("lay_out_block.comp");
    unsetenv("VOLUME_STUDIO_SHADER_DIR");
    return blocksOf(program).at("MixedBlock");
}

TEST_F(BlockLayoutTest, ABlockOfAllKindsOfMembersIsAsItsStruct) {
    EXPECT_EQ(differences(kMixedLayout, mixedBlock()), std::vector<std::string>());
}

TEST_F(BlockLayoutTest, MembersThatAreMovedOrMissingAreTold) {
    struct Moved {
        glm::vec4 place{0};
        glm::ivec4 counts[2]{};
        glm::mat4 turn{1};
        float loose[4]{};
        glm::vec4 added{0};
    };
    const BlockMember members[] = {VS_BLOCK_MEMBER(Moved, place), VS_BLOCK_MEMBER(Moved, turn),
                                   VS_BLOCK_MEMBER(Moved, loose), VS_BLOCK_MEMBER(Moved, added)};
    const BlockLayout layout{"MixedBlock", sizeof(Moved), members};
    EXPECT_FALSE(isWhole(layout)); // `counts` is not listed
    EXPECT_EQ(differences(layout, mixedBlock()),
              (std::vector<std::string>{"turn is 64 bytes at 48 in C++, 64 bytes at 16 in the shader",
                                        "loose is 16 bytes at 112 in C++, 64 bytes at 112 in the shader",
                                        "added is not in the shader", "counts is not in C++",
                                        "the block is 144 bytes in C++, 176 in the shader"}));
}

TEST_F(BlockLayoutTest, AListWithoutTheLastMemberIsNotWhole) {
    const auto allButLast = std::span(kMixedMembers).first(std::size(kMixedMembers) - 1);
    EXPECT_FALSE(isWhole({"MixedBlock", sizeof(MixedBlock), allButLast}));
}

} // namespace
} // namespace vs::gl
