// A surface is met from air, or whatever is around it is not known.
float iorAround() { return 1.0; }
