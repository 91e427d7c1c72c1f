# Writes OUTPUT, a C++ file that holds the parts of a study's page from SOURCE: `cmake -DSOURCE=… -DOUTPUT=… -P embed_study_page.cmake`.
set(text "#include \"session/study_page.h\"\n\nnamespace inhabit::session {\nnamespace {\n\n")
foreach(part IN ITEMS html css js)
  file(READ ${SOURCE}/page.${part} bytes HEX)
  # As numbers, because a string literal of this size is more than the standard promises.
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  string(APPEND text "constexpr char k_${part}[] = {${bytes}'\\0'};\n")
endforeach()
string(APPEND text "\n}  // namespace\n\nStudyPageParts study_page_parts() {\n"
       "  return {{k_html, sizeof k_html - 1}, {k_css, sizeof k_css - 1}, {k_js, sizeof k_js - 1}};\n}\n\n"
       "}  // namespace inhabit::session\n")
file(WRITE ${OUTPUT} "${text}")
