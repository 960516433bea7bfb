# The bill of materials of the programs (tools/make_sbom.py), made with them and installed beside the documents. Where dpkg, which knows
# whose the libraries are, or Python is not there, there is none.
find_package(Python3 COMPONENTS Interpreter)
find_program(DPKG_QUERY dpkg-query)
if(NOT Python3_Interpreter_FOUND OR NOT DPKG_QUERY)
  message(STATUS "No bill of materials: it needs Python and dpkg-query")
  return()
endif()
set(VS_SBOM ${PROJECT_BINARY_DIR}/sbom.cdx.json)
# Each time: packages can change while the programs stay.
add_custom_target(sbom ALL
  COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/make_sbom.py --version ${PROJECT_VERSION} --output ${VS_SBOM}
    $<TARGET_FILE:vstudio> $<TARGET_FILE:volume-studio> $<TARGET_FILE:volume-studio-decoder>
  BYPRODUCTS ${VS_SBOM} VERBATIM COMMENT "Listing what the programs need")
# Who builds only the programs installs them without it.
install(FILES ${VS_SBOM} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/volume-studio OPTIONAL)
