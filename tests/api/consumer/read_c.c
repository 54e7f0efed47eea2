/* Says how many points and cells a .ravel file holds, or what is wrong with it. */
#include <ravel/ravel_c.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** words) {
    static char bytes[1 << 16];
    ravel_mesh* mesh = NULL;
    ravel_summary holds;
    ravel_error error;
    size_t size = 0;
    if (count > 1) {
        FILE* file = fopen(words[1], "rb");
        if (file == NULL) return 3;
        size = fread(bytes, 1, sizeof bytes, file);
        fclose(file);
    }
    if (ravel_decode(bytes, size, NULL, &mesh, &error) != RAVEL_DONE) {
        printf("%s: %s\n", ravel_code_name(error.code), error.sentence);
        return 4;
    }
    ravel_summary_init(&holds, sizeof holds);
    ravel_mesh_summary(mesh, &holds, NULL);
    printf("%u points, %u cells\n", (unsigned)holds.points, (unsigned)holds.cells);
    ravel_mesh_free(mesh);
    return 0;
}
