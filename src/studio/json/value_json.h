// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/value_json.h"
#include "studio/operations/operation.h"

namespace vs {

// The values that only operations are made of, in session files: how each type is read by a rule, written,
// and described in the schema. Private to the files that read and write operations. read() throws
// SessionError with the place where it reads.

void read(const JsonReader& reader, studio::Clip::Box& value, const Rule& rule);
void read(const JsonReader& reader, sculpt::PenPoint& value, const Rule& rule);
// A preset's name, or a whole function.
void read(const JsonReader& reader, render::TransferFunction& value, const Rule& rule);
void read(const JsonReader& reader, render::Background& value, const Rule& rule);

Json write(const studio::Clip::Box& value, const Rule& rule);
Json write(const sculpt::PenPoint& value, const Rule& rule);
// A preset by its name, another function whole.
Json write(const render::TransferFunction& value, const Rule& rule);
Json write(const render::Background& value, const Rule& rule);

Json schemaOf(Type<studio::Clip::Box>, const Rule& rule, Json& definitions);
Json schemaOf(Type<sculpt::PenPoint>, const Rule& rule, Json& definitions);
Json schemaOf(Type<render::Background>, const Rule& rule, Json& definitions);

} // namespace vs
