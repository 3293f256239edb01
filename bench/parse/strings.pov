// Texts built in loops: numbers written out, digits turned round, letters counted, words put together.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Letters = "abcdefghijklmnopqrstuvwxyz";
#declare Length = 0;
#declare Line = "";
#for (I, 1, 120000)
  #declare Line = concat(Line, substr(Letters, 1 + mod(I * 7, 26), 1));
  #if (strlen(Line) >= 60)
    #declare Length = Length + strlen(Line);
    #declare Line = "";
  #end
#end
#debug concat("total letters ", str(Length, 0, 0), " ", Line, "\n")

#declare Palindromes = 0;
#for (I, 1, 30000)
  #declare Text = str(I, 0, 0);
  #declare Turned = "";
  #declare K = strlen(Text);
  #while (K > 0)
    #declare Turned = concat(Turned, substr(Text, K, 1));
    #declare K = K - 1;
  #end
  #if (strcmp(Text, Turned) = 0)
    #declare Palindromes = Palindromes + 1;
  #end
#end
#debug concat("total palindromes ", str(Palindromes, 0, 0), "\n")

#declare Sum = 0;
#for (I, 1, 120000)
  #declare Text = concat("<", str(I / 7, 0, 3), ",", vstr(3, <I, I / 2, I / 3>, ";", 0, 2), ">");
  #declare Sum = Sum + strlen(Text) + asc(substr(Text, 3, 1));
#end
#debug concat("total written ", str(Sum, 0, 0), "\n")

#declare Names = array[26];
#for (I, 0, 25) #declare Names[I] = chr(97 + I); #end
#declare Word = "";
#declare Sum = 0;
#for (I, 1, 90000)
  #declare Word = concat(strupr(Names[mod(I, 26)]), Names[mod(I * 3, 26)]);
  #if (Word = "Ba" | strlen(Word) != 2)
    #declare Sum = Sum + 1;
  #end
  #declare Sum = Sum + val(concat("1", str(mod(I, 10), 0, 0)));
#end
#debug concat("total words ", str(Sum, 0, 0), " ", Word, "\n")

camera { location -5*z look_at 0 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }
