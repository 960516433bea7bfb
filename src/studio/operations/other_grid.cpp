// SPDX-License-Identifier: Apache-2.0
#include "studio/operations/other_grid.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace vs::studio {

namespace {

template <typename T>
struct IsOptional : std::false_type {};
template <typename T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <typename T>
struct IsList : std::false_type {};
template <typename T>
struct IsList<std::vector<T>> : std::true_type {};
template <typename T>
struct IsVariant : std::false_type {};
template <typename... T>
struct IsVariant<std::variant<T...>> : std::true_type {};

// Goes through everything that an operation says of itself, and changes what is in voxels or steps: units are
// part of the descriptions.
class Converter {
public:
    explicit Converter(const OtherGrid& grid) : grid_(grid) {}

    template <typename T>
    void convert(T& value, const Rule& rule) const {
        if constexpr (IsOptional<T>::value) {
            if (value) {
                convert(*value, rule);
            }
        } else if constexpr (IsList<T>::value) {
            for (auto& element : value) {
                convert(element, rule);
            }
        } else if constexpr (IsVariant<T>::value) {
            std::visit([&](auto& one) { convert(one, rule); }, value);
        } else if constexpr (Described<T>) {
            convertFields(value, T::fields());
        } else {
            convertNumbers(value, std::string_view(rule.unit));
        }
    }

private:
    template <typename T, typename Fields>
    void convertFields(T& object, const Fields& fields) const {
        forEachField(fields, [&](const auto& field) {
            using F = std::remove_cvref_t<decltype(field)>;
            if (!field.applies(object)) {
                return;
            }
            if constexpr (F::kPresence == Presence::Group) {
                convertFields(object, field.inner);
            } else {
                convert(valueOf(object, field.access), field.rule);
            }
        });
    }

    template <typename T>
    void convertNumbers(T& value, std::string_view unit) const {
        if constexpr (std::is_same_v<T, glm::dvec3>) {
            value = unit == "voxels" ? value * grid_.scale + grid_.offset : value;
        } else if constexpr (std::is_same_v<T, glm::ivec3>) {
            const glm::dvec3 place = glm::dvec3(value) * grid_.scale + grid_.offset;
            value = unit == "voxels" ? glm::max(glm::ivec3(glm::floor(place + 0.5)), glm::ivec3(0)) : value;
        } else if constexpr (std::is_same_v<T, Clip::Box>) {
            convertNumbers(value.lo, unit);
            convertNumbers(value.hi, unit);
        } else if constexpr (std::is_same_v<T, double>) {
            value *= unit == "steps" ? grid_.steps : 1;
        }
    }

    const OtherGrid& grid_;
};

// So many generations go as far.
int asFar(int generations, double steps) { return int(std::ceil(generations * steps - 1e-9)); }

// Voxels of the finest level stay what they are; `before`: the voxels that the operation spoke of.
template <typename Op>
void keepFinest(Op& op, const std::vector<glm::ivec3>& before, const OtherGrid& grid) {
    if (grid.isFromFinest && op.finest.empty()) {
        op.finest = before;
    }
    if (grid.isToFinest && !op.finest.empty()) {
        op.voxels = std::move(op.finest);
        op.finest.clear();
    }
}

// Strokes and trails tell where voxels are; those that only a finer level has are told by these alone.
template <typename Op>
bool isOfFinestAlone(const Op& op) {
    bool isDrawn = !op.strokes.empty();
    if constexpr (requires { op.trails; }) {
        isDrawn = isDrawn || !op.trails.empty();
    }
    return op.voxels.empty() && !op.finest.empty() && !isDrawn;
}

// The voxel that one of the finest level lies in.
glm::ivec3 sceneVoxelOf(glm::ivec3 finest, const OtherGrid& sceneFromFinest) {
    const glm::dvec3 place = glm::dvec3(finest) * sceneFromFinest.scale + sceneFromFinest.offset;
    // The last of a level whose size was rounded down lies in none of a coarser one.
    return glm::clamp(glm::ivec3(glm::floor(place + 0.5)), glm::ivec3(0), sceneFromFinest.dims - 1);
}

template <typename Op>
void takeFromFinest(Op& op, const OtherGrid& sceneFromFinest) {
    if (isOfFinestAlone(op)) {
        for (const glm::ivec3 voxel : op.finest) {
            op.voxels.push_back(sceneVoxelOf(voxel, sceneFromFinest));
        }
        const auto isBefore = [](glm::ivec3 a, glm::ivec3 b) {
            return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
        };
        std::sort(op.voxels.begin(), op.voxels.end(), isBefore);
        op.voxels.erase(std::unique(op.voxels.begin(), op.voxels.end()), op.voxels.end());
    }
    op.finest.clear();
}

// Does so of operations that say one voxel. On a coarser grid it is looked for again where it was drawn.
template <typename Op>
void takeOneFromFinest(Op& op, const OtherGrid& sceneFromFinest) {
    const bool isSame = sceneFromFinest.scale == glm::dvec3(1);
    if (op.finest && !op.voxel && (isSame || !op.pixel || !op.canvas)) {
        op.voxel = sceneVoxelOf(*op.finest, sceneFromFinest);
    }
    op.finest.reset();
}

// What descriptions do not tell.
void convertMore(Sweep& op, const Sweep& before, const OtherGrid& grid) {
    op.pitch = before.pitch; // of samples, in steps of the grid that is cut
    if (!op.path.isDrawn()) {
        for (glm::dvec2& point : op.mask.points) { // about the path
            point *= grid.steps;
        }
    }
}
void convertMore(Grow& op, const Grow& /*before*/, const OtherGrid& grid) {
    op.generations = op.generations ? std::optional(asFar(*op.generations, grid.generations)) : std::nullopt;
}
void convertMore(Rewind& op, const Rewind& /*before*/, const OtherGrid& grid) {
    op.generations = asFar(op.generations, grid.generations);
}
void convertMore(ShowGeneration& op, const ShowGeneration& /*before*/, const OtherGrid& grid) {
    op.generation = asFar(op.generation, grid.generations);
}
void convertMore(Absorb& op, const Absorb& before, const OtherGrid& grid) {
    op.expansions = op.expansions ? std::optional(asFar(*op.expansions, grid.generations)) : std::nullopt;
    if (!op.strokes.empty()) {
        op.voxels.clear();
    }
    keepFinest(op, before.voxels, grid);
}
void convertMore(Seed& op, const Seed& before, const OtherGrid& grid) {
    if (!op.strokes.empty() || !op.trails.empty()) {
        op.voxels.clear();
    }
    keepFinest(op, before.voxels, grid);
}
// Likewise, of operations that say one voxel; `isLookedFor`: for the scene's it is looked again.
template <typename Op>
void keepOneFinest(Op& op, const Op& before, const OtherGrid& grid, bool isLookedFor) {
    if (grid.isFromFinest && !op.finest) {
        op.finest = before.voxel;
    }
    if (isLookedFor) {
        op.voxel.reset();
    }
    if (grid.isToFinest && op.finest) {
        op.voxel = std::exchange(op.finest, std::nullopt);
    }
}
void convertMore(KeepConnected& op, const KeepConnected& before, const OtherGrid& grid) {
    keepOneFinest(op, before, grid, op.pixel && op.canvas);
}
void convertMore(EditSegment& op, const EditSegment& before, const OtherGrid& grid) {
    keepOneFinest(op, before, grid, op.pixel && op.canvas);
}
void convertMore(CorrectGeometry& op, const CorrectGeometry& /*before*/, const OtherGrid& grid) {
    op.spacing = op.spacing ? std::optional(*op.spacing / grid.scale) : std::nullopt;
}
template <typename T>
void convertMore(T& /*op*/, const T& /*before*/, const OtherGrid& /*grid*/) {}

} // namespace

OtherGrid otherGrid(const volume::GridGeometry& from, const volume::GridGeometry& to) {
    const glm::dmat4 map = to.voxelFromWorld() * from.worldFromVoxel;
    OtherGrid grid;
    for (int axis = 0; axis < 3; ++axis) {
        grid.scale[axis] = map[axis][axis];
        grid.offset[axis] = map[3][axis];
        for (int other = 0; other < 3; ++other) {
            if (other != axis && std::abs(map[axis][other]) * from.dims[axis] > 1e-3) {
                throw Error("the levels' axes lie in different directions; a session of one cannot be "
                            "replayed on the other");
            }
        }
    }
    grid.steps = from.stepMm() / to.stepMm();
    grid.generations = grid.steps;
    grid.dims = to.dims;
    return grid;
}

Operation onGrid(Operation operation, const OtherGrid& grid) {
    std::visit(
        [&](auto& op) {
            const auto before = op;
            Converter(grid).convert(op, {});
            convertMore(op, before, grid);
        },
        operation);
    return operation;
}

bool namesFinest(const Operation& operation) {
    return std::visit(
        [](const auto& op) {
            if constexpr (requires { op.finest.empty(); }) {
                return !op.finest.empty();
            } else if constexpr (requires { op.finest.has_value(); }) {
                return op.finest.has_value();
            }
            return false;
        },
        operation);
}

Operation withoutFinest(Operation operation, const OtherGrid& sceneFromFinest) {
    std::visit(
        [&](auto& op) {
            if constexpr (requires { op.finest.empty(); }) {
                takeFromFinest(op, sceneFromFinest);
            } else if constexpr (requires { op.finest.has_value(); }) {
                takeOneFromFinest(op, sceneFromFinest);
            }
        },
        operation);
    return operation;
}

} // namespace vs::studio
