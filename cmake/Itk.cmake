# vs_use_itk(TARGET COMPONENT ...): compiles TARGET with these parts of ITK.
function(vs_use_itk TARGET)
  find_package(ITK 5.2 REQUIRED COMPONENTS ${ARGN})
  target_include_directories(${TARGET} SYSTEM PRIVATE ${ITK_INCLUDE_DIRS})
  target_link_libraries(${TARGET} PRIVATE ${ITK_LIBRARIES})
  # Debian's ITK was configured with GCC and its generated compiler check refuses every other compiler. Its include guard
  # and what the headers take from it, for Clang:
  target_compile_definitions(${TARGET} PRIVATE
    "$<$<CXX_COMPILER_ID:Clang>:ITK_COMPILER_DETECTION_H;ITK_NOEXCEPT=noexcept;ITK_CONSTEXPR=constexpr;ITK_NULLPTR=nullptr>")
endfunction()
