# The pages of the manual in the folder PAGES take MathJax, and all that it loads for them, from the copy beside them.
file(GLOB pages "${PAGES}/*.html")
set(number_of_pages_with_formulas 0)
foreach(page IN LISTS pages)
  file(STRINGS "${page}" scripts REGEX "<script.* src=.*MathJax.js")
  foreach(script IN LISTS scripts)
    math(EXPR number_of_pages_with_formulas "${number_of_pages_with_formulas} + 1")
    if(NOT script MATCHES " src=\"(\\./)?mathjax/MathJax.js\"")
      message(FATAL_ERROR "${page}: ${script}")
    endif()
  endforeach()
endforeach()
if(number_of_pages_with_formulas EQUAL 0)
  message(FATAL_ERROR "no page with formulas in ${PAGES}")
endif()

file(STRINGS "${PAGES}/index.html" parts REGEX "jax: *\\[|extensions: *\\[")
if(NOT parts MATCHES "tex2jax.js" OR NOT parts MATCHES "input/TeX" OR NOT parts MATCHES "output/SVG")
  message(FATAL_ERROR "other parts of MathJax than those that are there: ${parts}")
endif()
foreach(file MathJax.js extensions/tex2jax.js extensions/MathEvents.js extensions/MathMenu.js extensions/MathZoom.js
             jax/element/mml/jax.js jax/element/mml/optable/BasicLatin.js jax/input/TeX/config.js jax/input/TeX/jax.js
             jax/output/SVG/config.js jax/output/SVG/jax.js jax/output/SVG/autoload/mtable.js
             jax/output/SVG/fonts/TeX/fontdata.js jax/output/SVG/fonts/TeX/Main/Regular/Main.js)
  if(NOT EXISTS "${PAGES}/mathjax/${file}")
    message(FATAL_ERROR "not there: ${PAGES}/mathjax/${file}")
  endif()
endforeach()
