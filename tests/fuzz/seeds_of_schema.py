# SPDX-License-Identifier: Apache-2.0
"""Sessions with every operation, and the words that stand in them, from the schema: whatever is added to that is fuzzed too."""
import json

PER_SESSION = 10
# What a schema does not say: names that must exist, and members of which an operation needs one or another.
TEXTS = {"transferFunction": "ct_bone", "orientation": "LPS"}
NEEDED = {"planes", "strokes", "points", "pixel"}


class Schema:
    def __init__(self, path):
        self.whole = json.loads(path.read_text())

    def resolved(self, schema):
        while "$ref" in schema:
            schema = self.whole["$defs"][schema["$ref"].rsplit("/", 1)[1]]
        return schema

    def value(self, schema, is_full):
        """Something that the schema allows, with all members that may be given or with few."""
        schema = self.resolved(schema)
        if "oneOf" in schema:
            return self.value(schema["oneOf"][0], is_full)
        if "const" in schema or "enum" in schema:
            return schema.get("const", schema.get("enum", [None])[0])
        if schema.get("type") == "object":
            return {name: TEXTS.get(name) or self.value(one, is_full) for name, one in schema["properties"].items()
                    if is_full or name in NEEDED or name in schema.get("required", [])}
        if schema.get("type") == "array":
            count = max(schema.get("minItems", 0), min(2, schema.get("maxItems", 2)))
            # A range goes up, and so do points.
            return [moved(self.value(schema.get("items", {"type": "number"}), is_full), n) for n in range(count)]
        if schema.get("type") == "boolean":
            return True
        if schema.get("type") == "string":
            return "#808080" if "#" in schema.get("pattern", "") else "name"
        if schema.get("type") == "null":
            return None
        least, most = schema.get("minimum", 0), schema.get("maximum", 100)
        return max(least, min(most, 1)) if schema.get("type") == "integer" else float(max(least, min(most, 0.25)))

    def words(self):
        """All names of members, and all texts that are one of several."""
        found = set()

        def look(schema):
            if isinstance(schema, dict):
                found.update(schema.get("properties", {}))
                found.update(one for one in [schema.get("const"), *schema.get("enum", [])] if isinstance(one, str))
                for one in schema.values():
                    look(one)
            elif isinstance(schema, list):
                for one in schema:
                    look(one)

        look(self.whole)
        return sorted(found)


def moved(value, by):
    """The next element of a list: other numbers, which stay between 0 and 1 where they have been."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return value + by * (1 if isinstance(value, int) else 0.25)
    return [moved(one, by) for one in value] if isinstance(value, list) else value


def sessions(path):
    """All operations, ten a session, those of a session with all that may be said of them and those of the next with little."""
    schema = Schema(path)
    kinds = schema.whole["properties"]["operations"]["items"]["oneOf"]
    found = []
    for is_full in (False, True):
        for first in range(0, len(kinds), PER_SESSION):
            operations = [schema.value(kind, is_full) for kind in kinds[first:first + PER_SESSION]]
            found.append({"volumeStudioSession": 2, "volume": {"path": "head.nrrd"}, "precision": 16, "operations": operations})
    found.append({"volumeStudioSession": 2, "volume": {"block": [4, 4, 4], "spacing": [1, 2, 3]}, "operations": []})
    found.append({"volumeStudioSession": 2, "volume": {"phantom": "head", "dims": [16, 16, 16], "seed": 7}, "operations": []})
    return found
