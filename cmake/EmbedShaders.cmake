# vs_embed_shaders(TARGET): compiles every src/*/shaders/* file into TARGET as one table of texts,
# found at run time by its path below src/ ("render/shaders/cast_rays.comp").
# Run as a script (-P) it writes that table; see the end of the file.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(VS_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
  function(vs_embed_shaders TARGET)
    file(GLOB SHADERS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*/shaders/*)
    set(TABLE ${PROJECT_BINARY_DIR}/generated/embedded_shaders.cpp)
    add_custom_command(OUTPUT ${TABLE}
      COMMAND ${CMAKE_COMMAND} "-DROOT=${PROJECT_SOURCE_DIR}/src" "-DOUTPUT=${TABLE}" -P ${VS_EMBED_SCRIPT}
      DEPENDS ${SHADERS} ${VS_EMBED_SCRIPT} VERBATIM COMMENT "Embedding shaders")
    set_source_files_properties(${TABLE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # it is made, and often
    target_sources(${TARGET} PRIVATE ${TABLE})
  endfunction()
  return()
endif()

file(GLOB SHADERS RELATIVE ${ROOT} ${ROOT}/*/shaders/*)
set(TEXT "#include \"gl/embedded_shaders.h\"\n\nnamespace vs::gl {\nnamespace {\nconst EmbeddedShader kTable[] = {\n")
foreach(SHADER IN LISTS SHADERS)
  file(READ ${ROOT}/${SHADER} SOURCE)
  string(APPEND TEXT "    {\"${SHADER}\", R\"~~~(${SOURCE})~~~\"},\n")
endforeach()
string(APPEND TEXT "};\n} // namespace\nstd::span<const EmbeddedShader> embeddedShaders() { return kTable; }\n} // namespace vs::gl\n")
file(WRITE ${OUTPUT} "${TEXT}")
