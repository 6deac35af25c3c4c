// Plans and checks as text: certificate (JSON), table, picture (SVG), page that plays the machining (HTML), set-up sheet (HTML, PDF).
#pragma once

#include "clearcut/plan.h"
#include "clearcut/text.h"
#include "clearcut/verify.h"
#include "model/results/findings.h"
#include "pipeline/texts.h"
#include "report/picture/svg_writer.h"
#include "report/sheet/sheet_writers.h"

namespace clearcut {

using pipeline::CertificateBasis;
using pipeline::setup_sheet_of;
using pipeline::write_animation;
using pipeline::write_certificate;
using pipeline::write_page;
using pipeline::write_picture;
using pipeline::write_segments;
using pipeline::write_selection_table;
using pipeline::write_setup_sheet;
using pipeline::write_table;
using pipeline::write_values;
using report::CertificateFile;
using report::CertificateProof;
using report::joined_setup_sheets;
using report::require_pdf;
using report::setup_sheet_html;
using report::setup_sheets_pdf;
using report::SetupSheet;
using report::svg_path;

}  // namespace clearcut
