# vs_warnings: the warnings that every target of ours is built with, and the sanitizers when asked for.
add_library(vs_warnings INTERFACE)
target_compile_options(vs_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual -Wundef $<$<BOOL:${VOLUME_STUDIO_STRICT}>:-Werror>)
if(VOLUME_STUDIO_SANITIZE)
  target_compile_options(vs_warnings INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(vs_warnings INTERFACE -fsanitize=address,undefined)
endif()
