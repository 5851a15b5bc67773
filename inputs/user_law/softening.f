c     Elasticity whose stiffness falls with the strain: VUSDFLD sets a field, and the VUMAT scales its moduli by 1 minus it.
c     PROPS of the VUMAT: Young's modulus, Poisson's ratio. PROPS of VUSDFLD: the strain at which the stiffness is gone,
c     the strain that deletes. STATEV: the first deletes, the second is the largest strain along an axis so far.
      subroutine vusdfld(
     1  nblock, nstatev, nfieldv, nprops, ndir, nshr,
     2  jElemUid, kIntPt, kLayer, kSecPt,
     3  stepTime, totalTime, dt, cmname,
     4  coordMp, direct, T, charLength, props,
     5  stateOld, stateNew, field)
      include 'vaba_param.inc'
      dimension props(nprops), jElemUid(nblock), coordMp(nblock,*),
     1  direct(nblock,3,3), T(nblock,3,3), charLength(nblock),
     2  stateOld(nblock,nstatev), stateNew(nblock,nstatev),
     3  field(nblock,nfieldv)
      character*80 cmname
      parameter (nrData = 6)
      character*3 cData(maxblk*nrData)
      dimension rData(nblock,nrData), jData(maxblk*nrData)
      jStatus = 1
      call vgetvrm('LE', rData, jData, cData, jStatus)
      if (jStatus .ne. 0) call xplb_exit
      do k = 1, nblock
        e = max(rData(k,1), rData(k,2), rData(k,3), stateOld(k,2))
        stateNew(k,2) = e
        if (e .gt. props(2)) stateNew(k,1) = 0.d0
        field(k,1) = min(e / props(1), 1.d0)
      end do
      return
      end

      subroutine vumat(
     1  nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal,
     2  stepTime, totalTime, dt, cmname, coordMp, charLength,
     3  props, density, strainInc, relSpinInc,
     4  tempOld, stretchOld, defgradOld, fieldOld,
     5  stressOld, stateOld, enerInternOld, enerInelasOld,
     6  tempNew, stretchNew, defgradNew, fieldNew,
     7  stressNew, stateNew, enerInternNew, enerInelasNew)
      include 'vaba_param.inc'
      dimension props(nprops), density(nblock), coordMp(nblock,*),
     1  charLength(nblock), strainInc(nblock,ndir+nshr),
     2  relSpinInc(nblock,nshr), tempOld(nblock),
     3  stretchOld(nblock,ndir+nshr), defgradOld(nblock,ndir+2*nshr),
     4  fieldOld(nblock,nfieldv), stressOld(nblock,ndir+nshr),
     5  stateOld(nblock,nstatev), enerInternOld(nblock),
     6  enerInelasOld(nblock), tempNew(nblock),
     7  stretchNew(nblock,ndir+nshr), defgradNew(nblock,ndir+2*nshr),
     8  fieldNew(nblock,nfieldv), stressNew(nblock,ndir+nshr),
     9  stateNew(nblock,nstatev), enerInternNew(nblock),
     1  enerInelasNew(nblock)
      character*80 cmname
      do k = 1, nblock
        e = props(1) * (1.d0 - fieldNew(k,1))
        twomu = e / (1.d0 + props(2))
        xlambda = twomu * props(2) / (1.d0 - 2.d0 * props(2))
        trace = strainInc(k,1) + strainInc(k,2) + strainInc(k,3)
        do i = 1, ndir
          stressNew(k,i) = stressOld(k,i) + xlambda * trace
     1                   + twomu * strainInc(k,i)
        end do
        do i = ndir + 1, ndir + nshr
          stressNew(k,i) = stressOld(k,i) + twomu * strainInc(k,i)
        end do
      end do
      return
      end
