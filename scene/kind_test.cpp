#include "scene/kind.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace inhabit::scene;

TEST_CASE("words of names from three conventions") {
  CHECK(words_of("Dining_Table_16_2", ' ') == "dining table");
  CHECK(words_of("TVStand", ' ') == "tv stand");
  CHECK(words_of("kitchenUpperCabinet", '-') == "kitchen-upper-cabinet");
  CHECK(words_of("Fridge & Freezer", '-') == "fridge-freezer");
  CHECK(words_of("42", ' ').empty());
}

TEST_CASE("kinds from Sweet Home 3D and AI2-THOR names") {
  CHECK(kind_of("eTeks#bed140x190") == "bed");
  CHECK(kind_of("Bedside table") == "bedside table");
  CHECK(kind_of("Dining_Table_16_2") == "dining table");
  CHECK(kind_of("Bed_27") == "bed");
  CHECK(kind_of("Dog_Bed_1_3") == "pet bed");
  CHECK(kind_of("RoboTHOR_sofa_alrid") == "sofa");
  CHECK(kind_of("RoboTHOR_office_chair_jules") == "office chair");
  CHECK(kind_of("TV_Stand_206_1") == "tv stand");
  CHECK(kind_of("Television_19") == "tv");
  CHECK(kind_of("Floor_Lamp_15") == "floor lamp");
  CHECK(kind_of("Kitchen upper cabinet") == "upper cabinet");
  CHECK(kind_of("Countertop_Island_6x3") == "kitchen island");
  CHECK(kind_of("Schrank").empty());
  CHECK(kind_of("Schrank", "eTeks#wardrobe", 2) == "wardrobe");
  CHECK(kind_of("Table", "eTeks#squareTable", 0.4) == "coffee table");
  CHECK(kind_of("Table", "eTeks#squareTable", 0.75) == "table");
}

TEST_CASE("every kind stands once in the table and is its own kind") {
  std::set<std::string_view> seen;
  for (const KindRow& row : kind_table()) {
    CHECK_MESSAGE(seen.insert(row.kind).second, std::string(row.kind));
    CHECK(kind_of(row.kind) == row.kind);
    CHECK(find_kind(row.kind) == &row);
  }
  CHECK(find_kind("spaceship") == nullptr);
}
