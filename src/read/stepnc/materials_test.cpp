#include "read/stepnc/materials.h"

#include <gtest/gtest.h>

#include "model/work_material.h"

namespace clearcut::read::stepnc {
namespace {

TEST(StepNcMaterials, AreRecognisedByTheirUsualNames) {
  const std::pair<const char*, const char*> expected[] = {{"6061 aluminium", "aluminium"},
                                                          {"EN AW-6082 T6", "aluminium"},
                                                          {"EN-AW6060", "aluminium"},
                                                          {"AlMg4,5Mn", "aluminium"},
                                                          {"7075-T651", "aluminium"},
                                                          {"AlMgSi1", "aluminium"},
                                                          {"3.2315", "aluminium"},
                                                          {"C45", "steel"},
                                                          {"Ck45", "steel"},
                                                          {"C45E", "steel"},
                                                          {"St37-2", "steel"},
                                                          {"ST-50 STEEL", "steel"},
                                                          {"S235JR", "steel"},
                                                          {"1.0503", "steel"},
                                                          {"SAE 1020 ACO SEM LIGA", "steel"},
                                                          {"42CrMo4", "alloy-steel"},
                                                          {"1.7225 steel", "alloy-steel"},
                                                          {"AISI 4140", "alloy-steel"},
                                                          {"1.2379", "alloy-steel"},
                                                          {"1.4301", "stainless"},
                                                          {"AISI 316L", "stainless"},
                                                          {"X5CrNi18-10 steel", "stainless"},
                                                          {"stainless steel", "stainless"},
                                                          {"Edelstahl", "stainless"},
                                                          {"CuZn39Pb3", "brass"},
                                                          {"CW614N", "brass"},
                                                          {"Ms58", "brass"},
                                                          {"EN-GJL-250", "cast-iron"},
                                                          {"Ti6Al4V", "titanium"},
                                                          {"POM-C", "plastic"},
                                                          {"MDF", "mdf"},
                                                          {"oak", "hardwood"}};
  for (const auto& [text, material] : expected) {
    EXPECT_EQ(recognised_material(text), material) << text;
    EXPECT_TRUE(work_material_named(material)) << material;
  }
}

TEST(StepNcMaterials, AreNotGuessedWhereNamesAreUnknownOrContradictEachOther) {
  for (const char* text : {"", "id", "C45 aluminium", "CuSn8", "aluminium bronze", "ISO 4017", "P CARBIDE",
                           "1.4841", "drawing 1020", "part C"})
    EXPECT_EQ(recognised_material(text), "") << text;
}

}  // namespace
}  // namespace clearcut::read::stepnc
