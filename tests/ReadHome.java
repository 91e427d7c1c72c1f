import com.eteks.sweethome3d.io.HomeFileRecorder;
import com.eteks.sweethome3d.model.Home;
import com.eteks.sweethome3d.model.HomeFurnitureGroup;
import com.eteks.sweethome3d.model.HomePieceOfFurniture;
import java.util.List;
import java.util.Locale;

/** Reads homes with Sweet Home 3D itself and prints every piece: name, x, y, elevation, angle. */
class ReadHome {
  static void print(List<HomePieceOfFurniture> pieces) {
    for (HomePieceOfFurniture piece : pieces) {
      if (piece instanceof HomeFurnitureGroup) {
        print(((HomeFurnitureGroup) piece).getFurniture());
        continue;
      }
      System.out.printf(Locale.ROOT, "%s\t%.4f\t%.4f\t%.4f\t%.6f%n", piece.getName(), piece.getX(), piece.getY(),
          piece.getElevation(), piece.getAngle());
    }
  }

  public static void main(String[] files) throws Exception {
    for (String file : files) {
      Home home = new HomeFileRecorder(0, false, null, false, true).readHome(file);
      System.out.printf("home\t%d\t%d\t%d%n", home.getWalls().size(), home.getRooms().size(), home.getFurniture().size());
      print(home.getFurniture());
    }
  }
}
