// Plans and checks as text: certificate (JSON), table, picture (SVG), page that plays the machining (HTML).
#pragma once

#include "clearcut/plan.h"
#include "clearcut/text.h"
#include "clearcut/verify.h"
#include "model/results/not_machined.h"
#include "pipeline/texts.h"
#include "report/picture/svg_path.h"
#include "report/sheet/setup_sheet.h"

namespace clearcut {

using pipeline::CertificateBasis;
using pipeline::write_certificate;
using pipeline::write_page;
using pipeline::write_picture;
using pipeline::write_segments;
using pipeline::write_selection_table;
using pipeline::write_setup_sheet;
using pipeline::write_table;
using pipeline::write_values;
using report::CertificateFile;
using report::joined_setup_sheets;
using report::svg_path;

}  // namespace clearcut
