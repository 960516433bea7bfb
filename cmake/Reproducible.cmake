# The same sources give the same programs, wherever they lie and whenever they are built (doc/reproducible_builds.md).
# Messages of checks name their file from the project's folder on; debuggers still get whole paths, by which they find sources.
add_compile_options(-fmacro-prefix-map=${PROJECT_BINARY_DIR}/=build/ -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
# The first format of Qt's resources has no times of files in it.
set(VS_RESOURCE_OPTIONS OPTIONS --format-version 1)
