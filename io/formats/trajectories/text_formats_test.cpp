#include "io/formats/trajectories/splines.h"
#include "io/formats/trajectories/test_trajectories.h"

using namespace inhabit::io;
using inhabit::scene::Fix;
using inhabit::scene::Trajectories;

TEST_CASE("PeTrack text has its frame rate and unit in the comments above it") {
  const Trajectories t = read_text(
      "\xef\xbb\xbf# PeTrack project: a.pet\r\n# framerate: 16.5 fps\r\n\r\n# id frame x/cm y/cm z/cm\r\n"
      "1 94 -554.5 309.25 176\r\n1\t95  -550 309 176 761\r\n",
      {}, "run.txt");
  CHECK(t.frame_rate == 16.5);
  CHECK(t.name == "run");
  CHECK(t.fixes == std::vector<Fix>{{94, 1, -5.545, 3.0925}, {95, 1, -5.5, 3.09}});
  CHECK(read_text("#framerate: 25\n# in metres\n2 1 0.5 0.25\n2 2 0.55 0.25\n").fixes[0] == Fix{1, 2, 0.5, 0.25});
  CHECK(read_text("#framerate: 25\n#FR ID x/m y/m\n9 1 0 0\n10 1 0.04 0\n").fixes[0] == Fix{9, 1, 0, 0});
}

TEST_CASE("PeTrack text without a unit is asked about") {
  CHECK(refusal("# framerate: 25\n1 0 1 1\n1 1 1.05 1\n") ==
        "the file does not say its unit: --unit cm|m says it; with m the median speed would be 1.3 m/s");
  const Trajectories t = read_text("# framerate: 25\n1 0 100 100\n1 1 105 100\n", {.unit = LengthUnit::centimetres});
  CHECK(t.fixes[1] == Fix{1, 1, 1.05, 1});
  CHECK(t.remarks.empty());
}

TEST_CASE("numbers alone are asked about with what would be walking") {
  std::string hermes, trajnet;
  for (int frame = 0; frame < 20; ++frame) {
    for (int person = 1; person <= 3; ++person) {
      hermes += std::to_string(person) + " " + std::to_string(84 + frame) + " " + std::to_string(154 + 100 * person) +
                " " + std::to_string(679 - 7 * frame) + " 175.4\r\n";
      trajnet += std::to_string(10 * frame) + ".0\t" + std::to_string(person) + ".0\t" + std::to_string(3 * person) +
                 ".5\t" + std::to_string(frame * 0.5) + "\n";
    }
  }
  CHECK(refusal(hermes) ==
        "the file says neither its unit nor its frame rate: --unit cm|m and --fps N say it; with cm and 16 fps the "
        "median "
        "speed would be 1.1 m/s, with 25 fps 1.8 m/s");
  CHECK(refusal(hermes, {.frame_rate = 16}) ==
        "the file does not say its unit: --unit cm|m says it; with cm the median speed would be 1.1 m/s");
  CHECK(refusal(hermes, {.unit = LengthUnit::centimetres}) ==
        "the file does not say its frame rate: --fps N says it; with 16 fps the median speed would be 1.1 m/s, with 25 "
        "fps "
        "1.8 m/s");
  const Trajectories t = read_text(hermes, {.unit = LengthUnit::centimetres, .frame_rate = 16});
  CHECK(t.fixes[0] == Fix{84, 1, 2.54, 6.79});
  // Frames first: who walks evenly is told by the ways between the rows.
  CHECK(refusal(trajnet).find("with m and 25 fps the median speed would be 1.2 m/s") != std::string::npos);
  CHECK(read_text(trajnet, {.unit = LengthUnit::metres, .frame_rate = 25}).fixes[1] == Fix{0, 2, 6.5, 0});
}

TEST_CASE("obsmat takes y from its fifth column and the frame rate from its speeds") {
  std::string slow, fast;
  for (int k = 0; k < 8; ++k) {
    slow += "  " + std::to_string(780 + 6 * k) + " 1.0e+00 " + std::to_string(0.6 * k) + " 0 3.5 1.5 0 0\n";
    fast += std::to_string(10 * k) + " 1 " + std::to_string(0.6 * k) + " 0 3.5 1.5 0 0\n";
  }
  const Trajectories t = read_text(slow);
  CHECK(t.frame_rate == 15);
  CHECK(t.fixes[1].frame == 786);
  CHECK(t.fixes[1].x == doctest::Approx(0.6));
  CHECK(t.fixes[1].y == 3.5);
  CHECK(read_text(fast).frame_rate == 25);
  // Nobody moves: the rows are 0.4 s apart by custom.
  CHECK(read_text("0 1 2 0 3 0 0 0\n6 1 2 0 3 0 0 0\n").frame_rate == 15);
}

TEST_CASE("TrajNet++ is a JSON object per line") {
  const Trajectories t = read_text(
      "{\"scene\": {\"id\": 0, \"p\": 1, \"s\": 10, \"e\": 30, \"fps\": 2.5, \"tag\": 2}}\n"
      "{\"track\": {\"f\": 10, \"p\": 1, \"x\": 1.5, \"y\": 2.25}}\n{\"track\": {\"f\": 20, \"p\": 1, \"x\": 2, \"y\": "
      "2}}\n"
      "{\"track\": {\"f\": 30, \"p\": 1, \"x\": 9, \"y\": 9, \"prediction_number\": 0, \"scene_id\": 0}}\n");
  CHECK(t.frame_rate == 25);
  CHECK(t.fixes == std::vector<Fix>{{10, 1, 1.5, 2.25}, {20, 1, 2, 2}});
  CHECK(has_remark(t, "1 predicted positions"));
  CHECK(refusal("{\"track\": {\"f\": 10, \"p\": 1, \"x\": \"1\", \"y\": 2}}") == "line 1: \"x\" must be a number");
  CHECK(refusal("{\"track\": {\"f\": 1.5, \"p\": 1, \"x\": 1, \"y\": 2}}") == "line 1: \"f\" must be a whole number");
  CHECK(refusal("{\"scene\": {}}\n{\"trak\": 1}") == "line 2: neither a \"track\" nor a \"scene\"");
}

TEST_CASE("tables name their columns in any case and order") {
  const Trajectories ours = read_text("id,frame,x,y,t\n4,10,1.5,2,0.625\n4,11,1.5,2.0625,0.6875\n");
  CHECK(ours.frame_rate == 16);
  CHECK(ours.fixes == std::vector<Fix>{{10, 4, 1.5, 2}, {11, 4, 1.5, 2.0625}});
  const Trajectories crowdit = read_text("time,pedID,posX,posY\n0.00,0,40.5,35\n0.50,0,40.5,35.5\n1.00,0,40.5,36\n");
  CHECK(crowdit.frame_rate == 2);
  CHECK(crowdit.fixes[2] == Fix{2, 0, 40.5, 36});
  const Trajectories german = read_text("Frame;\"ID\";Y [cm];X [cm]\n1;2;300;100\n2;2;305;100\n", {.frame_rate = 25});
  CHECK(german.fixes[0] == Fix{1, 2, 1, 3});
  std::string speeds = "ID,Frame,x,y,v_x,v_y\n";
  for (int k = 0; k < 8; ++k)
    speeds += "21," + std::to_string(1010 + 10 * k) + "," + std::to_string(0.16 * k) + ",0,0.4,0\n";
  CHECK(read_text(speeds).frame_rate == 25);
  CHECK(refusal("id,frame,x,y\n1,1,0,0\n1,2,0.05,0\n") ==
        "the file does not say its frame rate: --fps N says it; with 16 fps the median speed would be 0.80 m/s, with "
        "25 fps "
        "1.2 m/s");
  CHECK(refusal("name,x,y\na,1,2\n", {}, "a.csv") ==
        "the first line must name the columns id, frame or t, x and y, as in id,frame,x,y");
  CHECK(refusal("id,frame,x,y\n1,1,0,\n") == "line 2: y: is empty");
  CHECK(refusal("id,frame,x,y\n1,1,0\n") == "line 2: has 3 columns where 4 are needed");
  CHECK(refusal("id,frame,x,y\n1,1,0,2\na,1,0,2\n") == "line 3: person: \"a\" is no whole number");
}

TEST_CASE("times written with few digits keep the rate of the frames") {
  std::string text = "id,t,x,y\n";
  for (int frame = 0; frame < 100; ++frame)
    text += "1," + std::to_string(std::round(frame / 24.0 * 100) / 100) + "," + std::to_string(0.05 * frame) + ",0\n";
  const Trajectories t = read_text(text);
  CHECK(t.frame_rate == 24);
  CHECK(t.fixes.size() == 100);
  CHECK(t.fixes[99].frame == 99);
}

TEST_CASE("uneven times are interpolated and said to be") {
  const Trajectories t = read_text("id,t,x,y\n1,0,0,0\n1,0.1,0.1,0\n1,0.2,0.2,0\n1,0.33,0.33,0\n1,0.5,0.5,0\n");
  CHECK(has_remark(t, "interpolated"));
  for (const Fix& fix : t.fixes) CHECK(fix.x == doctest::Approx(fix.frame / t.frame_rate));
}

TEST_CASE("Viswalk has comments after stars and its table after a dollar sign") {
  const std::string head = "$VISION\n* File: a.pp\n*\n$PEDESTRIAN:NO;SIMSEC;COORDCENTX;COORDCENTY;SPEED\n";
  const Trajectories t = read_text(head + "7;0.10;1.5;2.5;4\n7;0.20;1.6;2.5;4\n* end\n7;0.30;1.7;2.5;4\n");
  CHECK(t.frame_rate == 10);
  CHECK(t.fixes[2] == Fix{3, 7, 1.7, 2.5});
  CHECK(refusal("$VISION\n$PEDESTRIAN:NO;SIMSEC;COORDCENTX\n7;0.1;1\n") == "line 2: the column COORDCENTY is missing");
  CHECK(refusal("$VISION\n* nothing\n") == "no line starts with $PEDESTRIAN: and names the columns");
}

TEST_CASE("footsteps of Vadere become even frames up to where the last one ends") {
  const std::string text =
      "#IDXCOL=2,DATACOL=6,SEP=' '\npedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1 "
      "targetId-PID2\n1 0.4 0.9 2 7 2.5 7 8\n1 0.9 1.4 2.5 7 2.5 7.5 8\n2 0.5 0.5 0 0 0 0 8\n";
  const Trajectories t = read_text(text, {.frame_rate = 10});
  REQUIRE(t.fixes.size() == 12);
  CHECK(t.fixes.front().frame == 4);
  CHECK(t.fixes.back().frame == 14);
  CHECK(t.fixes.back().y == doctest::Approx(7.5));
  CHECK(t.fixes[1].x == doctest::Approx(2.1));
  CHECK(read_text(text).frame_rate == 25);
  CHECK(has_remark(read_text(text), "interpolated at 25 frames per second; --fps N says otherwise"));
  CHECK(refusal("pedestrianId simTime x y\n1 2 3 4\n").find("the column startX is missing") != std::string::npos);
}

TEST_CASE("of SUMO's traffic the persons are read") {
  const std::string text =
      "<?xml version=\"1.0\"?>\n<fcd-export>\n<timestep time=\"0.00\"><vehicle id=\"v\" x=\"1\" y=\"1\"/>"
      "<person id=\"ped1\" x=\"1.5\" y=\"2\" angle=\"0\" speed=\"1\"/></timestep>\n"
      "<timestep time=\"0.50\"><person id=\"ped1\" x=\"2\" y=\"2\"/><person id=\"ped0\" x=\"0\" y=\"0\"/></timestep>\n"
      "</fcd-export>\n";
  const Trajectories t = read_text(text);
  CHECK(t.frame_rate == 2);
  CHECK(t.fixes == std::vector<Fix>{{0, 1, 1.5, 2}, {1, 1, 2, 2}, {1, 2, 0, 0}});
  CHECK(has_remark(t, "in order of appearance; the first is ped1"));
  CHECK(has_remark(t, "1 positions of vehicles"));
  const Trajectories numbered =
      read_text("<fcd-export><timestep time=\"0\"><person id=\"9\" x=\"1\" y=\"1\"/></timestep></fcd-export>");
  CHECK(numbered.fixes[0].person == 9);
  CHECK(refusal("<fcd-export>\n<timestep time=\"0\">\n<person id=\"p\" y=\"2\"/></timestep></fcd-export>") ==
        "line 3, column 2: person p: x and y must be numbers");
  CHECK(refusal("<fcd-export><timestep").starts_with("line 1, column "));
}

TEST_CASE("splines need a homography and move evenly between control points") {
  const std::string text =
      "2 - the number of splines\n3 - Num of control points\n0 0 0 90 - (2D point, m_id)\n100 0 4 90 - (2D point, "
      "m_id)\n"
      "100 50 6 0 - (2D point, m_id)\n1 - Num of control points\n-20 -30 5 0.5 - (2D point, m_id)\n";
  CHECK(refusal(text) ==
        "positions are pixels: --homography FILE with the 3x3 matrix from the image to metres is needed");
  const TestFolder folder;
  REQUIRE(write_file_atomically(folder / "H.txt", "0.02 0 5\n0 0.02 6\n0 0 1\n").ok());
  const Trajectories t = read_text(text, {.homography = folder / "H.txt"});
  CHECK(t.frame_rate == 25);
  REQUIRE(t.fixes.size() == 8);
  CHECK(t.fixes[2].x == doctest::Approx(6));
  CHECK(t.fixes[5].y == doctest::Approx(6.5));
  CHECK(t.fixes[6].person == 2);
  REQUIRE(write_file_atomically(folder / "H.txt", "0.02 0 5\n0 0.02 6\n0 0\n").ok());
  CHECK(refusal(text, {.homography = folder / "H.txt"}) ==
        (folder / "H.txt").string() + ": a homography is nine numbers, not 8");
  CHECK_FALSE(read_homography("1 0 0 2 0 0 0 0 1").ok());
  CHECK(refusal(text.substr(0, 60), {.homography = folder / "none.txt"}).find("none.txt") != std::string::npos);
}
