# vs_warnings: the warnings that every target of ours is built with, and the sanitizers when asked for.
add_library(vs_warnings INTERFACE)
target_compile_options(vs_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual -Wundef $<$<BOOL:${VOLUME_STUDIO_STRICT}>:-Werror>)
if(VOLUME_STUDIO_SANITIZE)
  # A finding ends the program, so that no test passes with one. Little optimisation and line numbers only: a build of half the time.
  # Offsets from null pointers are not looked for: ITK's iterators, which are headers, make them.
  # A target with the property VS_UNCHECKED goes without, for a build that is about others.
  string(CONCAT checks "-fsanitize=${VOLUME_STUDIO_SANITIZE};-fno-sanitize-recover=all;-fno-sanitize=pointer-overflow;"
    "-fno-omit-frame-pointer;-O1;-g1")
  target_compile_options(vs_warnings INTERFACE "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:VS_UNCHECKED>>>:${checks}>")
  target_compile_definitions(vs_warnings INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(vs_warnings INTERFACE -fsanitize=${VOLUME_STUDIO_SANITIZE})
endif()
