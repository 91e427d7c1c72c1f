#pragma once
#include "render/pen.h"

/// How furniture looks from above. One function per symbol; which kind gets which stands in symbol_table.cpp.
namespace inhabit::render::symbols {

void box(const Pen& p);    // anything: its front marked
void plain(const Pen& p);  // no front
void bed(const Pen& p);
void cot(const Pen& p);
void sofa(const Pen& p);  // arms, back, cushions; an armchair when narrow
void chair(const Pen& p);
void office_chair(const Pen& p);
void stool(const Pen& p);
void bench(const Pen& p);
void seat(const Pen& p);  // a theatre's: drawn in crowds, so simple
void table(const Pen& p);
void round_table(const Pen& p);
void desk(const Pen& p);
void wardrobe(const Pen& p);  // hangers, doors
void drawers(const Pen& p);
void shelf(const Pen& p);  // rows of books
void screen(const Pen& p);
void plant(const Pen& p);
void lamp(const Pen& p);
void rug(const Pen& p);
void toilet(const Pen& p);
void basin(const Pen& p);
void bathtub(const Pen& p);
void shower(const Pen& p);
void stove(const Pen& p);
void fridge(const Pen& p);
void washer(const Pen& p);
void grill(const Pen& p);
void bin(const Pen& p);
void carousel(const Pen& p);
void stage(const Pen& p);
void book(const Pen& p);
void laptop(const Pen& p);
void keyboard(const Pen& p);
void pencil(const Pen& p);
void plate(const Pen& p);
void mug(const Pen& p);
void frame(const Pen& p);
void paper(const Pen& p);
void coat_rack(const Pen& p);
void piano(const Pen& p);
void pool_table(const Pen& p);
void parasol(const Pen& p);
void leaf(const Pen& p);  // a door as an object

}  // namespace inhabit::render::symbols
