# cmake -DSERVE=apps/serve/page -DPAGE=apps/web/page -DBUILT=FOLDER -DOPTIONS=FILE -DSITE=FOLDER -P WebSite.cmake
# Puts together the folder that any static host serves: the server's page with another way to the pipeline, the command as
# WebAssembly from BUILT, its options, and what makes the page an app that works without a network.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${SITE})
file(MAKE_DIRECTORY ${SITE})

file(STRINGS ${SERVE}/scripts.txt scripts)
set(app "")
foreach(script IN LISTS scripts)
  set(file ${SERVE}/${script})
  if(script STREQUAL "server.js")
    set(file ${PAGE}/local.js)
  endif()
  file(READ ${file} text)
  string(APPEND app "${text}\n")
endforeach()
file(WRITE ${SITE}/app.js "${app}")

# Nothing may be sent anywhere: the page reaches its own folder only, and the report in its frame takes this over.
set(policy "default-src 'none'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:;")
string(APPEND policy " connect-src 'self' blob:; worker-src 'self'; manifest-src 'self'; frame-src blob:; base-uri 'none'; form-action 'none'")
set(icon "<link rel=\"icon\" href=\"data:,\">")
file(READ ${SERVE}/index.html index)
string(FIND "${index}" "${icon}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "${SERVE}/index.html holds no ${icon}, in whose place the web page's head is put")
endif()
string(REPLACE "${icon}" "<meta http-equiv=\"Content-Security-Policy\" content=\"${policy}\">
<meta name=\"theme-color\" content=\"#0b57a8\">
<link rel=\"icon\" href=\"icon.svg\" type=\"image/svg+xml\">
<link rel=\"manifest\" href=\"manifest.webmanifest\">" index "${index}")
file(WRITE ${SITE}/index.html "${index}")

configure_file(${OPTIONS} ${SITE}/options.json COPYONLY)
foreach(file ${SERVE}/app.css ${PAGE}/run_command.js ${PAGE}/worker.js ${PAGE}/icon.svg ${PAGE}/manifest.webmanifest
        ${BUILT}/clearcut.js ${BUILT}/clearcut.wasm)
  file(COPY ${file} DESTINATION ${SITE})
endforeach()

file(GLOB names RELATIVE ${SITE} ${SITE}/*)
set(files "'./'")
set(hashes "")
foreach(name IN LISTS names)
  file(SHA256 ${SITE}/${name} hash)
  string(APPEND hashes ${hash})
  string(APPEND files ", '${name}'")
endforeach()
string(SHA256 version "${hashes}")
string(SUBSTRING ${version} 0 16 version)
configure_file(${PAGE}/offline.js.in ${SITE}/offline.js @ONLY)
