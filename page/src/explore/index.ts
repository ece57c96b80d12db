// The page that the program serves.

import { start } from "./main.js";

void start();
